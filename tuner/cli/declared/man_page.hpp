#pragma once
// The manual page, from what the command line was declared with.

#include <string>

#include "tuner/cli/declared/declared.hpp"

namespace armtune::internal::cli {

/// armtune(1) in man(7)'s macros. `version` stands at the foot. Text that could be taken for a macro or an
/// escape is written so that it is not.
std::string man_page(const DeclaredProgram& program, const std::string& version);

}  // namespace armtune::internal::cli
