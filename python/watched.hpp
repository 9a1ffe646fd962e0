#pragma once
// Calls long-running functions of the C++ interface from Python. Progress reports and warnings are passed on
// to Python, and Ctrl-C ends the work early.

#include <string>
#include <vector>

#include "armtune/progress.hpp"
#include "python/interruptible.hpp"

namespace armtune::internal::python {

/// Raises armtune.Interrupted, a KeyboardInterrupt whose attribute `result` holds the results so far.
[[noreturn]] void raise_interrupted(pybind11::object result);
/// Issues each sentence as a Python warning.
void issue_warnings(const std::vector<std::string>& sentences);

/// Calls run(watch) without the GIL and returns its result. progress: a Python function that takes a
/// Progress, or None. Ctrl-C ends `run` early; Interrupted is then raised with the result that `run`
/// returned. Warnings are issued when `run` has ended.
template <class Run>
auto watched(pybind11::object progress, Run run) {
  Work work;
  Callback callback(std::move(progress));
  std::vector<std::string> warnings;
  const auto task = [&](const std::atomic<bool>& stop) {
    Watch watch;
    watch.stop = &stop;
    watch.progress = [&](const Progress& at) { callback(at); };
    watch.warning = [&](const std::string& sentence) { warnings.push_back(sentence); };
    return run(watch);
  };
  try {
    auto result = interruptible(work, callback, task,
                                [](auto so_far) { raise_interrupted(pybind11::cast(std::move(so_far))); });
    issue_warnings(warnings);
    return result;
  } catch (const pybind11::error_already_set&) {
    try {
      issue_warnings(warnings);
    } catch (const pybind11::error_already_set&) {  // the exception of `run` is raised
    }
    throw;
  }
}

}  // namespace armtune::internal::python
