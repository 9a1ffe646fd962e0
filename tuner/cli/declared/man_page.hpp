#pragma once
// Generates the manual page from the commands and options that the program declares.

#include <string>

#include "tuner/cli/declared/declared.hpp"

namespace armtune::internal::cli {

/// Returns armtune(1) in the macros of man(7), with `version` in the footer. Text that could be read as a
/// macro or an escape sequence is escaped.
std::string man_page(const DeclaredProgram& program, const std::string& version);

}  // namespace armtune::internal::cli
