#pragma once
// Simulates candidate gain sets in parallel. The unit of work is one rollout. Every worker has its own
// simulation models. Therefore the results do not depend on the number of workers, or on the process in which
// a worker runs.

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "tuner/samples/sample_set.hpp"
#include "tuner/workers/conditions.hpp"
#include "tuner/workers/rollout_pool.hpp"

namespace armtune::internal {

/// Returns the plan for simulating the scenarios with their own arms or, if there is a set of random arms
/// (sample_set.hpp), with each arm of this set. Corners are additional scenarios for stability margins
/// (corner.hpp). They are always simulated with their own arm, and must come last in `scenarios`.
RolloutPlan plan_of(const std::vector<Scenario>& scenarios, Stepper stepper,
                    const std::optional<SampleSet>& samples);

class CandidateRunner {
 public:
  /// count: number of threads (>= 1). If there is a sample set, every scenario is simulated with each arm of
  /// the set, and the results are combined into one per scenario.
  CandidateRunner(const std::vector<Scenario>& scenarios, Stepper stepper, int count,
                  std::optional<SampleSet> samples = std::nullopt);
  /// pool: must be made for the plan that plan_of() returns for these samples.
  CandidateRunner(std::unique_ptr<RolloutPool> pool, std::optional<SampleSet> samples);

  int count() const { return pool_->count(); }
  long rollouts_done() const { return pool_->rollouts_done(); }
  /// Returns the simulated time of all rollouts together [s].
  double simulated() const { return pool_->simulated(); }
  /// Returns the pool, for rollouts other than those of whole candidates.
  RolloutPool& pool() { return *pool_; }
  /// Returns the number of arms that a scenario is simulated with.
  std::size_t arms_of(std::size_t scenario) const {
    return samples_ && scenario < pool_->plan().drawn ? arms(*samples_) : 1;
  }
  /// Combines the results of all scenarios, each with all its arms in order, into one result per scenario.
  std::vector<RolloutResult> fold(std::vector<RolloutResult> results) const;

  /// A function that is called once per candidate, as soon as all its scenarios are done. The candidates come
  /// in any order. The function is called from any thread, one call at a time.
  using Finished = std::function<void(std::size_t candidate, const std::vector<RolloutResult>& results)>;

  /// Simulates all scenarios for every candidate. Returns results[candidate][scenario], in the order of the
  /// plan's scenarios. Returns nothing if `stop` became true before all were done. `finished` was then called
  /// for the candidates that were done.
  std::optional<std::vector<std::vector<RolloutResult>>> run(std::span<const Gains> candidates,
                                                             const std::atomic<bool>& stop,
                                                             const Finished& finished = {},
                                                             const Conditions& conditions = {});

 private:
  /// One rollout of a candidate.
  struct Unit {
    std::size_t scenario;
    std::size_t sample;
  };
  std::size_t scenarios() const { return pool_->plan().scenarios.size(); }

  std::unique_ptr<RolloutPool> pool_;
  std::optional<SampleSet> samples_;
  std::vector<Unit> units_;         ///< rollouts of a candidate, longest scenario first
  std::vector<std::size_t> place_;  ///< [scenario]: index of the result of its first sample
};

}  // namespace armtune::internal
