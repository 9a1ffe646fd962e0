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
  /// Uses workers (at least one) made for that plan. Each is called from one thread at a time.
  RolloutPool(std::shared_ptr<const RolloutPlan> plan, std::vector<std::unique_ptr<RolloutWorker>> workers);

  const RolloutPlan& plan() const { return *plan_; }
  int count() const { return static_cast<int>(workers_.size()); }
  long rollouts_done() const { return done_; }
  /// Returns the simulated time of all rollouts together [s].
  double simulated() const { return simulated_; }

  /// Runs job(0) .. job(count - 1), started in that order. `finished` receives each result that was not
  /// interrupted, in any order, one call at a time, from any thread. No job is started once `stop` is true,
  /// and jobs under way are interrupted. The first exception ends the rest and is thrown again here.
  void run(std::size_t count, const std::function<RolloutJob(std::size_t)>& job,
           const std::atomic<bool>& stop, const std::function<void(std::size_t, RolloutResult&&)>& finished);

 private:
  std::shared_ptr<const RolloutPlan> plan_;
  std::vector<std::unique_ptr<RolloutWorker>> workers_;
  std::atomic<long> done_{0};
  std::atomic<double> simulated_{0.0};
};

}  // namespace armtune::internal
