#pragma once
// What a command tells on standard output.

#include <string_view>

namespace armtune::internal::cli {

/// Prints the text, without an exception where standard output cannot be written: what a run has found is
/// worth more than what it tells of it, and the program says at its end that something was not printed (see
/// flush_standard_output). Names out of files that would command a terminal are escaped, line by line.
void say(std::string_view text);

}  // namespace armtune::internal::cli
