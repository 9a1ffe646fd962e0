#pragma once
// Progress reports of functions that run for a long time, and a way to stop them early.

#include <atomic>
#include <cmath>
#include <functional>
#include <string>

namespace armtune {

/// The progress of one part of the work.
struct Progress {
  std::string work;  ///< name of the part, such as "margins of the start gains"
  long done = 0;
  long all = 0;               ///< total, in the units of `done`; 0: not known
  double seconds_left = NAN;  ///< estimate; NaN: not known
  std::string detail = {};    ///< the best result so far or the current step, in words
};

/// The callbacks and the stop flag of a long-running function. The callbacks are called from any thread, one
/// call at a time.
struct Watch {
  std::function<void(const Progress&)> progress = {};
  std::function<void(const std::string&)> warning = {};  ///< one sentence; the work continues
  const std::atomic<bool>* stop = nullptr;  ///< true: stop soon, keep what is finished; must outlive the work
};

}  // namespace armtune
