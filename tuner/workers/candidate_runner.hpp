#pragma once
// Simulates candidate gain sets in parallel. The unit of work is one rollout. Every worker has its own
// simulation models, so results depend neither on the number of workers nor on where they run.

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

/// Returns the plan for simulating the scenarios with their own arms, or with each arm of a sample set. The
/// corners of margins (corner.hpp) keep their own arm; they must come last.
RolloutPlan plan_of(const std::vector<Scenario>& scenarios, Stepper stepper,
                    const std::optional<SampleSet>& samples);

class CandidateRunner {
 public:
  /// count: threads (>= 1). With a sample set every scenario is run with each of its arms, and the results
  /// are combined into one per scenario.
  CandidateRunner(const std::vector<Scenario>& scenarios, Stepper stepper, int count,
                  std::optional<SampleSet> samples = std::nullopt);
  /// pool: made for the plan_of these samples.
  CandidateRunner(std::unique_ptr<RolloutPool> pool, std::optional<SampleSet> samples);

  int count() const { return pool_->count(); }
  long rollouts_done() const { return pool_->rollouts_done(); }
  /// Returns the simulated time of all rollouts together [s].
  double simulated() const { return pool_->simulated(); }

  /// Called once per candidate, as soon as all its scenarios are done: in any order, one call at a time, from
  /// any thread.
  using Finished = std::function<void(std::size_t candidate, const std::vector<RolloutResult>& results)>;

  /// Simulates all scenarios for every candidate. Returns results[candidate][scenario], in the order of the
  /// scenarios as given. Returns nothing if `stop` became true before all were done; `finished` has received
  /// the candidates that were done by then.
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
  /// Returns one result per scenario as given.
  std::vector<RolloutResult> fold(std::vector<RolloutResult> results) const;
  std::size_t scenarios() const { return pool_->plan().scenarios.size(); }
  /// Returns the number of arms that a scenario is simulated with.
  std::size_t samples(std::size_t scenario) const {
    return samples_ && scenario < pool_->plan().drawn ? arms(*samples_) : 1;
  }

  std::unique_ptr<RolloutPool> pool_;
  std::optional<SampleSet> samples_;
  std::vector<Unit> units_;         ///< of a candidate, longest scenario first
  std::vector<std::size_t> place_;  ///< [scenario]: place of the result of its first sample
};

}  // namespace armtune::internal
