#pragma once
// Long work that is under way, and the end of the interpreter. A thread that waits for Python's lock while
// the interpreter ends is unwound through C++ by force, which aborts the process. A daemon thread in tune()
// or simulate() therefore has to be out of them before.

#include <atomic>

namespace armtune::internal::python {

/// One call of a function that works for long. Made and destroyed with Python's lock.
class Work {
 public:
  /// Throws SystemExit, which ends a thread without a word, if the interpreter is about to end.
  Work();
  ~Work();
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  std::atomic<bool>& stop() { return stop_; }
  int of_process() const { return process_; }
  /// True if the interpreter is about to end. Then only `throw_exit` may follow.
  static bool ends_with_interpreter();
  /// Throws SystemExit.
  [[noreturn]] static void throw_exit();
  /// Never returns where the interpreter ended without waiting for this work any longer: Python's lock must
  /// not be asked for again. Called without the lock.
  static void stay_if_abandoned();

 private:
  std::atomic<bool> stop_{false};
  int process_;
};

/// Stops all work and waits until it has returned, for some seconds at most: a progress function of the
/// user's may hang. Called with Python's lock when the interpreter is about to end.
void end_all_work();

}  // namespace armtune::internal::python
