#pragma once
// Prints what a command reports on standard output.

#include <string_view>

namespace armtune::internal::cli {

/// Prints the text. Does not throw if standard output cannot be written, because the results of a run are
/// worth more than their printout; the program reports at its end that something was not printed (see
/// flush_standard_output). Control characters, which names from files may contain, are escaped line by line.
void say(std::string_view text);

}  // namespace armtune::internal::cli
