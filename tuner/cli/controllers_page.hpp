#pragma once
// What there is to know of every controller and its gains, as its declaration says it.

#include <string>

namespace armtune::cli {

/// For a terminal: the gains of each that others do not have.
std::string controllers_text();

/// For a page: every gain, with units and default search ranges. docs/controllers.md is this.
std::string controllers_markdown();

}  // namespace armtune::cli
