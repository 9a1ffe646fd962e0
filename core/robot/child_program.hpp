#pragma once
// Runs another program without a shell, with limits on its time and its output. armtune starts no other
// program than the one that expands xacro files, and this one only if the user asks for it.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace armtune::internal {

struct ChildLimits {
  double time = 60.0;              ///< wall-clock time after which the program is killed [s]
  std::size_t bytes = 32U << 20U;  ///< size of its output beyond which it is killed
};

enum class ChildEnd { kExited, kKilled, kTooSlow, kTooLarge, kInterrupted, kNotStarted };

struct ChildOutcome {
  ChildEnd end = ChildEnd::kNotStarted;
  int exit_code = -1;  ///< of kExited; of kNotStarted: errno
  std::string out;     ///< standard output of kExited
  std::string err;     ///< the first 64 kB of standard error
};

/// Returns the path of an executable file of this name in a folder of the environment variable PATH. Relative
/// folders in PATH are left out, because they could lead to a program that came with an input file.
std::optional<std::string> program_in_path(const std::string& name);

/// Runs the program and waits for its end. words: path and arguments. Its standard input is empty. Its output
/// goes to temporary files that have no name. The program and those that it has started are killed when a
/// limit is exceeded, or when this process receives a signal that it handles, such as SIGINT.
ChildOutcome run_child(const std::vector<std::string>& words, const ChildLimits& limits);

}  // namespace armtune::internal
