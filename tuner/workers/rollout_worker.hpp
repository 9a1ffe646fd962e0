#pragma once
// The interface of a worker, which simulates rollouts. It simulates one at a time or several at once, in this
// process or in another one.

#include <cstddef>
#include <optional>

#include "sim/rollout/rollout.hpp"
#include "tuner/workers/rollout_plan.hpp"

namespace armtune::internal {

struct GivenJob {
  std::size_t number = 0;
  RolloutJob job;
};

/// A source of jobs. A worker gets its jobs from it, and returns the results to it.
class JobSource {
 public:
  virtual ~JobSource() = default;
  /// Returns the largest number of jobs that a worker should do at the same time, so that jobs are left for
  /// the other workers.
  virtual std::size_t share() const = 0;
  /// Returns the next job to start, or nothing if no further job must be started.
  virtual std::optional<GivenJob> next() = 0;
  /// True if jobs under way must be abandoned. Workers call it often, every few control periods.
  virtual bool stopped() = 0;
  /// Takes the result of a job, which is complete or was interrupted because of stopped().
  virtual void finished(std::size_t number, RolloutResult&& result) = 0;
};

class RolloutWorker {
 public:
  RolloutWorker() = default;
  virtual ~RolloutWorker() = default;
  RolloutWorker(const RolloutWorker&) = delete;
  RolloutWorker& operator=(const RolloutWorker&) = delete;

  /// Does jobs of the plan that it was made for, until there are no more. A result depends only on plan and
  /// job. Throws FailedError if a rollout passes its deadline, or if the worker is lost.
  virtual void work(JobSource& jobs) = 0;
};

}  // namespace armtune::internal
