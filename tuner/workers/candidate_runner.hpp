#pragma once
// Candidates in parallel. The unit of work is one rollout; every worker has plants of its own, so results do
// not depend on the number of workers, nor on where they are.

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

/// Scenarios as they are, or as each arm of a sample set meets them. Corners of margins keep their own arm;
/// they come last.
RolloutPlan plan_of(const std::vector<Scenario>& scenarios, Stepper stepper,
                    const std::optional<SampleSet>& samples);

class CandidateRunner {
 public:
  /// count: threads (>= 1). With a sample set every scenario is run as each of its arms, and results are
  /// folded to one per scenario.
  CandidateRunner(const std::vector<Scenario>& scenarios, Stepper stepper, int count,
                  std::optional<SampleSet> samples = std::nullopt);
  /// pool: of the plan_of these samples.
  CandidateRunner(std::unique_ptr<RolloutPool> pool, std::optional<SampleSet> samples);

  int count() const { return pool_->count(); }
  long rollouts_done() const { return pool_->rollouts_done(); }
  /// Of all of them together [s].
  double simulated() const { return pool_->simulated(); }

  /// Called once per candidate, as soon as all its scenarios are done: in any order, one call at a time, from
  /// any thread.
  using Finished = std::function<void(std::size_t candidate, const std::vector<RolloutResult>& results)>;

  /// All scenarios for every candidate: results[candidate][scenario], the scenarios as given. Nothing if
  /// `stop` became true before all were done; what was finished by then went to `finished`.
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
  /// One result per scenario as given.
  std::vector<RolloutResult> fold(std::vector<RolloutResult> results) const;
  std::size_t scenarios() const { return pool_->plan().scenarios.size(); }
  /// The arms that a scenario is simulated with.
  std::size_t samples(std::size_t scenario) const {
    return samples_ && scenario < pool_->plan().drawn ? arms(*samples_) : 1;
  }

  std::unique_ptr<RolloutPool> pool_;
  std::optional<SampleSet> samples_;
  std::vector<Unit> units_;         ///< of a candidate, the longest scenario first
  std::vector<std::size_t> place_;  ///< [scenario]: of the result of its first sample
};

}  // namespace armtune::internal
