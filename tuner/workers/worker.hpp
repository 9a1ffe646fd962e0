#pragma once
// One worker: it does one rollout at a time, here or elsewhere.

#include <atomic>

#include "sim/rollout/rollout.hpp"
#include "tuner/workers/rollout_plan.hpp"

namespace armtune {

class Worker {
 public:
  Worker() = default;
  virtual ~Worker() = default;
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// The job of the plan it was made for; kInterrupted once `stop` is true. The result depends on plan and
  /// job alone. Throws std::runtime_error past the rollout's deadline, or if the worker is lost.
  virtual RolloutResult run(const RolloutJob& job, const std::atomic<bool>& stop) = 0;
};

}  // namespace armtune
