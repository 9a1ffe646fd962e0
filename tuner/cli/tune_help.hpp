#pragma once
// The text that `armtune tune --help` shows below its options.

#include <string>

namespace armtune::internal::cli {

/// Returns the names of bundled studies, the commands that print the lists, and an example.
std::string tune_help();

}  // namespace armtune::internal::cli
