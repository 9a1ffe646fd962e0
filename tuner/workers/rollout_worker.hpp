#pragma once
// One worker: it does rollouts, one at a time or several side by side, here or elsewhere.

#include <cstddef>
#include <optional>

#include "sim/rollout/rollout.hpp"
#include "tuner/workers/rollout_plan.hpp"

namespace armtune::internal {

struct GivenJob {
  std::size_t number = 0;
  RolloutJob job;
};

/// Where workers get their jobs and hand in their results.
class JobSource {
 public:
  virtual ~JobSource() = default;
  /// How many jobs a worker should have under way at most, lest others have none.
  virtual std::size_t share() const = 0;
  /// The next one to be started; none: there are no more, or no more are wanted.
  virtual std::optional<GivenJob> next() = 0;
  /// Whether what is under way is to be given up. Asked often: once per control period, say.
  virtual bool stopped() = 0;
  /// One that was given out is done, or was interrupted because of stopped().
  virtual void finished(std::size_t number, RolloutResult&& result) = 0;
};

class RolloutWorker {
 public:
  RolloutWorker() = default;
  virtual ~RolloutWorker() = default;
  RolloutWorker(const RolloutWorker&) = delete;
  RolloutWorker& operator=(const RolloutWorker&) = delete;

  /// Jobs of the plan it was made for, until there are no more. A result depends on plan and job alone.
  /// Throws FailedError past a rollout's deadline, or if the worker is lost.
  virtual void work(JobSource& jobs) = 0;
};

}  // namespace armtune::internal
