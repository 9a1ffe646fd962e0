#pragma once
// Types that all sessions share. A session does the work of one armtune command. Its caller passes a stop
// flag and the command line that repeats the run. The way in which the session ends becomes the exit code.

#include <atomic>
#include <chrono>
#include <string>
#include <vector>

namespace armtune::internal {

/// The command line of a run, for its journal and its provenance.
struct Invocation {
  std::vector<std::string> words;  ///< command line without the program, without --out, and without
                                   ///< options that do not change results
  std::string line;                ///< command that repeats the run, quoted for a shell
};

struct SessionContext {
  const std::atomic<bool>& stop;  ///< true: the session ends soon, keeping results; must outlive the session
  Invocation invocation = {};
};

/// The way in which a run ended. The values are exit codes of the program and are stored in the journal.
enum class Ending : int {
  kPassed = 0,        ///< complete, and every check passed
  kChecksFailed = 3,  ///< complete, but a check failed or nothing feasible was found
  kInterrupted = 130  ///< interrupted; what was finished is kept
};

/// A clock of the wall time since its construction.
class Stopwatch {
 public:
  /// Returns the wall time since construction [s].
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  }

 private:
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace armtune::internal
