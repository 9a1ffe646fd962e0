#pragma once
// Completion for shells, from what the command line was declared with.

#include <string>
#include <vector>

#include "tuner/cli/declared/declared.hpp"

namespace armtune::internal::cli {

/// bash and zsh.
const std::vector<std::string>& shell_names();

/// A script for one of them. Commands, options, and the words and bundled names that options and positionals
/// take are completed, else files. Throws InputError for another shell.
std::string completion(const DeclaredProgram& program, const std::string& shell);

}  // namespace armtune::internal::cli
