#pragma once
// Generates completion scripts for shells from the commands and options that the program declares.

#include <string>
#include <vector>

#include "tuner/cli/declared/declared.hpp"

namespace armtune::internal::cli {

/// Returns "bash" and "zsh".
const std::vector<std::string>& shell_names();

/// Returns the completion script for a shell. It completes commands and options. It also completes the values
/// of options and positional arguments. It offers the allowed words if only these are valid, otherwise
/// bundled names and paths of files. Throws InputError for a shell that is not in shell_names().
std::string completion(const DeclaredProgram& program, const std::string& shell);

}  // namespace armtune::internal::cli
