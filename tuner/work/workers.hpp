#pragma once
// Rollouts in parallel. The unit of work is one rollout; every worker has plants of its own, so results do
// not depend on the number of workers.

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sim/rollout/rollout.hpp"
#include "tuner/robustness/sample_set.hpp"

namespace armtune {

class Workers {
 public:
  /// count: threads (>= 1). With a sample set every scenario is run as each of its arms, and results are
  /// folded to one per scenario.
  Workers(const std::vector<Scenario>& scenarios, Stepper stepper, int count,
          std::optional<SampleSet> samples = std::nullopt);
  ~Workers();

  int count() const { return static_cast<int>(rollouts_.size()); }
  long rollouts_done() const { return done_; }

  /// Called once per candidate, as soon as all its scenarios are done: in any order, one call at a time, from
  /// any thread.
  using Finished = std::function<void(std::size_t candidate, const std::vector<RolloutResult>& results)>;

  /// All scenarios for every candidate: results[candidate][scenario], the scenarios as given. Nothing if
  /// `stop` became true before all were done; what was finished by then went to `finished`.
  /// limits: per scenario as given, where its rollouts end, those of every arm alike; empty: nowhere.
  std::optional<std::vector<std::vector<RolloutResult>>> run(std::span<const Gains> candidates,
                                                             const std::atomic<bool>& stop,
                                                             const Finished& finished = {},
                                                             const std::vector<EndLimits>& limits = {});

 private:
  /// One result per scenario as given.
  std::vector<RolloutResult> fold(std::vector<RolloutResult> results) const;
  Rollout& rollout(std::size_t worker, std::size_t scenario);

  std::optional<SampleSet> samples_;
  std::vector<Scenario>
      scenarios_;  ///< as they are run: with samples, scenario s of sample k at s * samples + k
  Stepper stepper_;
  std::vector<std::vector<std::unique_ptr<Rollout>>> rollouts_;  ///< [worker][scenario], made when first used
  std::vector<std::size_t> longest_first_;
  std::atomic<long> done_{0};
};

}  // namespace armtune
