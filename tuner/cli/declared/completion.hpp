#pragma once
// Generates completion scripts for shells from the commands and options that the program declares.

#include <string>
#include <vector>

#include "tuner/cli/declared/declared.hpp"

namespace armtune::internal::cli {

/// Returns "bash" and "zsh".
const std::vector<std::string>& shell_names();

/// Returns the completion script for a shell. It completes commands, options, and the words and bundled names
/// that options and positionals take; elsewhere it completes files. Throws InputError for another shell.
std::string completion(const DeclaredProgram& program, const std::string& shell);

}  // namespace armtune::internal::cli
