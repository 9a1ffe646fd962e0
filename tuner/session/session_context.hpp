#pragma once
// What every session is given: what stops it, and by which command it can be made again. And how it ends.

#include <atomic>
#include <chrono>
#include <string>
#include <vector>

namespace armtune::internal {

/// The command that a run is made by, for its journal and its provenance.
struct Invocation {
  std::vector<std::string> words;  ///< of the command line, without the program, --out and what results do
                                   ///< not depend on
  std::string line;                ///< that makes the run again, quoted for a shell
};

struct SessionContext {
  const std::atomic<bool>& stop;  ///< true: end soon, with what is finished; outlives the session
  Invocation invocation = {};
};

/// How a run ended. The values are the exit codes of the program, which a journal keeps.
enum class Ending : int {
  kPassed = 0,        ///< done, and every check passed
  kChecksFailed = 3,  ///< done, but a check failed, or nothing feasible was found
  kInterrupted = 130  ///< what was finished is kept
};

/// Wall time since it was made.
class Stopwatch {
 public:
  /// [s]
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  }

 private:
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace armtune::internal
