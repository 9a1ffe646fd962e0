#pragma once
// How long work is watched, and how it is ended early.

#include <atomic>
#include <cmath>
#include <functional>
#include <string>

namespace armtune {

/// How far a part of the work is.
struct Progress {
  std::string work;  ///< what is done, such as "margins of the start gains"
  long done = 0;
  long all = 0;               ///< units of `done`; 0: not known
  double seconds_left = NAN;  ///< about; NaN: not known
  std::string detail = {};    ///< the best so far, or where the work stands, for a person
};

/// What a function that works for long is given. Its functions are called from any thread, one call at a
/// time.
struct Watch {
  std::function<void(const Progress&)> progress = {};
  std::function<void(const std::string&)> warning = {};  ///< one sentence; the work continues
  const std::atomic<bool>* stop = nullptr;  ///< true: end soon, with what is finished; outlives the work
};

}  // namespace armtune
