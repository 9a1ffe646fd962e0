#pragma once
// Distributes jobs to threads, in order. Each job writes its result into a slot of its own, so results do not
// depend on which thread did which job.

#include <fmt/format.h>

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

#include "armtune/error.hpp"

namespace armtune::internal {

/// Calls job(worker, index) for index 0 .. count-1, started in that order, on `workers` threads (>= 1), which
/// include the caller's. No job is started once `stop` is true. After a first exception no further job is
/// started, and the exception is thrown again here.
inline void parallel_for(std::size_t count, int workers, const std::atomic<bool>& stop,
                         const std::function<void(std::size_t worker, std::size_t index)>& job) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr error;
  std::mutex error_mutex;
  const auto work = [&](std::size_t worker) {
    try {
      for (std::size_t i = next++; i < count && !stop; i = next++) job(worker, i);
    } catch (...) {
      const std::lock_guard lock(error_mutex);
      if (!error) error = std::current_exception();
      next = count;
    }
  };
  {
    std::vector<std::jthread> threads;
    try {
      for (int w = 1; w < workers; ++w) threads.emplace_back(work, static_cast<std::size_t>(w));
    } catch (const std::system_error& e) {
      next = count;  // the threads that have started must not do all jobs first
      throw FailedError(fmt::format("of {} threads, the system can start only {} ({}); give fewer workers",
                                    workers, threads.size() + 1, e.what()));
    }
    work(0);
  }
  if (error) std::rethrow_exception(error);
}

}  // namespace armtune::internal
