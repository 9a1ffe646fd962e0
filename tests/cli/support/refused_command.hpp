#pragma once
// Runs a command that the program refuses, and returns the error with its fields.

#include <string>
#include <vector>

#include "armtune/error.hpp"

namespace armtune::internal::test {

/// Runs the program with these arguments and expects it to refuse them: exit code 2, nothing on standard
/// output, and one line on standard error. Then runs the same command in this process and returns its error,
/// whose message must be that line. An error of the command line itself has no fields.
InputError refused_command(const std::vector<std::string>& arguments);

}  // namespace armtune::internal::test
