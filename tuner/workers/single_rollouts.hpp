#pragma once
// Simulates rollouts in this process, one at a time. Simulation models of earlier rollouts are kept and used
// again.

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
  /// The plan must outlive the object.
  explicit SingleRollouts(const RolloutPlan& plan) : plan_(plan), arms_(plan) {}

  /// Simulates a job. The result depends only on plan and job. `stop` is called once per control period. If
  /// it returns true, the rollout ends with the status kInterrupted. Throws FailedError if the rollout is not
  /// completed before its deadline.
  RolloutResult run(const RolloutJob& job, const std::function<bool()>& stop);

  PreparedArms& arms() { return arms_; }
  /// Returns the error for a job that was not completed before its deadline. arms: number of arms that were
  /// simulated at the same time; the deadline is multiplied by it; simulated: simulated time so far [s].
  FailedError late(const RolloutJob& job, int arms, double simulated) const;

 private:
  /// A simulation model that is ready for a rollout. Only a few models are kept.
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
