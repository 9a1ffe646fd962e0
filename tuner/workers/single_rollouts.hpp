#pragma once
// Rollouts of a plan in this process, one at a time.

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

#include "armtune/error.hpp"
#include "sim/rollout/rollout.hpp"
#include "tuner/workers/prepared_arms.hpp"
#include "tuner/workers/rollout_plan.hpp"

namespace armtune::internal {

class SingleRollouts {
 public:
  /// plan: outlives this.
  explicit SingleRollouts(const RolloutPlan& plan) : plan_(plan), arms_(plan) {}

  /// The result depends on plan and job alone; kInterrupted once `stop`, asked once per control period, is
  /// true. Throws FailedError past the rollout's deadline.
  RolloutResult run(const RolloutJob& job, const std::function<bool()>& stop);

  PreparedArms& arms() { return arms_; }
  /// What to throw when a job is not done within its deadline, times the arms that were simulated side by
  /// side. simulated: how far it came [s].
  FailedError late(const RolloutJob& job, int arms, double simulated) const;

 private:
  /// A plant made ready. Few are kept.
  struct Ready {
    std::size_t scenario;
    std::uint64_t sample;
    Engine engine;
    std::uint64_t used;
    std::unique_ptr<Rollout> rollout;
  };
  Rollout& rollout(const RolloutJob& job);

  const RolloutPlan& plan_;
  PreparedArms arms_;
  std::vector<Ready> ready_;
  std::uint64_t uses_ = 0;
};

}  // namespace armtune::internal
