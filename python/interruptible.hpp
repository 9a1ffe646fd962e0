#pragma once
// Runs long work without holding Python's global interpreter lock (GIL), so that other Python threads can
// run. Ctrl-C ends the work early.

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <optional>
#include <string>
#include <thread>

#include "python/work.hpp"

namespace armtune::internal::python {

/// A Python function, or None, that C++ can call from any thread. If the function raises an exception, the
/// work ends, and `interruptible` raises the exception again.
class Callback {
 public:
  explicit Callback(pybind11::object function) : function_(std::move(function)) {}

  template <class... Arguments>
  void operator()(Arguments&&... arguments) {
    if (function_.is_none()) return;
    const pybind11::gil_scoped_acquire lock;
    if (raised_) return;
    try {
      function_(std::forward<Arguments>(arguments)...);
    } catch (pybind11::error_already_set& error) {
      raised_.emplace(std::move(error));
      if (stop_ != nullptr) *stop_ = true;
    }
  }

  void stops(std::atomic<bool>& stop) { stop_ = &stop; }
  const std::optional<pybind11::error_already_set>& raised() const { return raised_; }

 private:
  pybind11::object function_;
  std::atomic<bool>* stop_ = nullptr;
  std::optional<pybind11::error_already_set> raised_;
};

/// Runs task(stop) in a thread of its own and without the GIL, while the calling thread checks for signals.
/// Ctrl-C sets `stop`, after which the task must end soon. KeyboardInterrupt is raised when it has ended.
/// Before that, if_interrupted is called with the result of the task, and may raise another exception
/// instead. If the interpreter is about to end, `stop` is set too, and SystemExit is raised.
template <class Task, class IfInterrupted>
auto interruptible(Work& work, Callback& callback, Task task, IfInterrupted if_interrupted) {
  constexpr std::chrono::milliseconds kLook{50};
  std::atomic<bool>& stop = work.stop();
  callback.stops(stop);
  std::optional<pybind11::error_already_set> signal;
  auto done = std::async(std::launch::async, [&] { return task(stop); });
  {
    const pybind11::gil_scoped_release without_lock;
    while (done.wait_for(kLook) != std::future_status::ready) {
      Work::stay_if_abandoned();
      const pybind11::gil_scoped_acquire lock;
      if (!signal && PyErr_CheckSignals() != 0) {
        signal.emplace();
        stop = true;
      }
    }
    Work::stay_if_abandoned();
  }
  if (Work::ends_with_interpreter()) Work::throw_exit();
  if (callback.raised()) throw pybind11::error_already_set(*callback.raised());
  if (signal) {
    if (signal->matches(PyExc_KeyboardInterrupt)) if_interrupted(done.get());
    throw std::move(*signal);
  }
  return done.get();
}

template <class Task>
auto interruptible(Work& work, Callback& callback, Task task) {
  return interruptible(work, callback, std::move(task), [](const auto&) {});
}

}  // namespace armtune::internal::python
