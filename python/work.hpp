#pragma once
// Keeps a list of the long work that is running, and stops it before the Python interpreter ends. If a thread
// waits for Python's global interpreter lock (GIL) while the interpreter ends, Python unwinds the thread's
// C++ stack by force, which aborts the process. A daemon thread must therefore leave functions such as tune()
// and simulate() before that.

#include <atomic>

namespace armtune::internal::python {

/// One call of a long-running function. A thread must hold the GIL to create or destroy an object.
class Work {
 public:
  /// Throws SystemExit if the interpreter is about to end. This ends a thread without a message.
  Work();
  ~Work();
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  std::atomic<bool>& stop() { return stop_; }
  int of_process() const { return process_; }
  /// True if the interpreter is about to end. The caller must then call `throw_exit`.
  static bool ends_with_interpreter();
  /// Throws SystemExit.
  [[noreturn]] static void throw_exit();
  /// Never returns if end_all_work has stopped waiting for work to return, since the thread must not request
  /// the GIL any more. Otherwise it returns at once. Call it without the GIL.
  static void stay_if_abandoned();

 private:
  std::atomic<bool> stop_{false};
  int process_;
};

/// Stops all work and waits until it has returned. It waits for some seconds at most, because a progress
/// function of the user may hang. Called with the GIL when the interpreter is about to end.
void end_all_work();

}  // namespace armtune::internal::python
