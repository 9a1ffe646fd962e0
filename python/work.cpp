#include "python/work.hpp"

#include <pybind11/pybind11.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <thread>
#include <vector>

namespace armtune::internal::python {
namespace {

/// The running work of this process. After a fork, entries of the parent process are copies without threads.
struct Works {
  std::mutex mutex;
  std::vector<Work*> all;
  std::atomic<bool> ending{false};
  std::atomic<bool> abandoned{false};
};

Works& works() {
  static auto* const kept = new Works;  // never freed, because threads outlive static objects
  return *kept;
}

}  // namespace

Work::Work() : process_(::getpid()) {
  Works& list = works();
  if (list.ending) throw_exit();
  const std::lock_guard lock(list.mutex);
  std::erase_if(list.all, [this](const Work* other) { return other->process_ != process_; });
  list.all.push_back(this);
}

Work::~Work() {
  const std::lock_guard lock(works().mutex);
  std::erase(works().all, this);
}

bool Work::ends_with_interpreter() {
  return works().ending;
}

void Work::throw_exit() {
  PyErr_SetNone(PyExc_SystemExit);
  throw pybind11::error_already_set();
}

void Work::stay_if_abandoned() {
  while (works().abandoned) std::this_thread::sleep_for(std::chrono::hours(1));
}

void end_all_work() {
  constexpr std::chrono::seconds kPatience{10};
  constexpr std::chrono::milliseconds kLook{2};
  Works& list = works();
  list.ending = true;
  const int process = ::getpid();
  const auto under_way = [&] {
    const std::lock_guard lock(list.mutex);
    return std::count_if(list.all.begin(), list.all.end(), [&](Work* work) {
      if (work->of_process() != process) return false;
      work->stop() = true;
      return true;
    });
  };
  const pybind11::gil_scoped_release without_lock;
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (under_way() > 0) {
    if (std::chrono::steady_clock::now() > end) {
      list.abandoned = true;
      return;
    }
    std::this_thread::sleep_for(kLook);
  }
}

}  // namespace armtune::internal::python
