#pragma once
// Every command on one page for docs/, from what the command line was declared with.

#include <string>

#include "tuner/cli/declared/declared.hpp"

namespace armtune::cli {

/// docs/commands.md is this.
std::string markdown_page(const DeclaredProgram& program);

}  // namespace armtune::cli
