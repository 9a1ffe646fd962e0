#pragma once
// A pool of workers that simulate rollouts in parallel. It distributes the jobs to them and collects the
// results.

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

#include "tuner/workers/rollout_worker.hpp"

namespace armtune::internal {

class RolloutPool {
 public:
  /// Makes `threads` (>= 1) workers in this process.
  RolloutPool(RolloutPlan plan, int threads);
  /// Uses workers (at least one) that were made for this plan. A worker is called from one thread at a time.
  RolloutPool(std::shared_ptr<const RolloutPlan> plan, std::vector<std::unique_ptr<RolloutWorker>> workers);

  const RolloutPlan& plan() const { return *plan_; }
  int count() const { return static_cast<int>(workers_.size()); }
  long rollouts_done() const { return done_; }
  /// Returns the simulated time of all rollouts together [s].
  double simulated() const { return simulated_; }

  /// Runs the jobs that `job` returns for 0 to count - 1, started in this order. `finished` receives the
  /// number and the result of each job that was not interrupted, in any order. It is called from any thread,
  /// one call at a time. As soon as `stop` is true, no further job is started, and jobs under way are
  /// interrupted. After a first exception no further job is started, and the exception is thrown again here.
  void run(std::size_t count, const std::function<RolloutJob(std::size_t)>& job,
           const std::atomic<bool>& stop, const std::function<void(std::size_t, RolloutResult&&)>& finished);

 private:
  std::shared_ptr<const RolloutPlan> plan_;
  std::vector<std::unique_ptr<RolloutWorker>> workers_;
  std::atomic<long> done_{0};
  std::atomic<double> simulated_{0.0};
};

}  // namespace armtune::internal
