#include "tuner/first_task/kept_limits.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "sim/rollout/applies.hpp"

namespace armtune::internal {

bool keeps_limits(const RolloutResult& result, double share) {
  const Metrics& metrics = result.metrics;
  return result.status == RolloutStatus::kCompleted && metrics[Metric::kJointVelocityMaxRatio] <= share &&
         metrics[Metric::kJointEffortMaxRatio] <= share &&
         !(metrics[Metric::kJointAccelerationMaxRatio] > share) &&
         !(metrics[Metric::kJointPositionMinMargin] < 0.0) && contact_text(metrics).empty();
}

EndLimits ends_of_kept_limits(const Scenario& scenario, double share) {
  const double beyond = std::nextafter(share, std::numeric_limits<double>::infinity());
  const double below = -std::numeric_limits<double>::min();  // rollouts treat smaller numbers as zero
  EndLimits limits = {{Metric::kJointVelocityMaxRatio, beyond},
                      {Metric::kJointEffortMaxRatio, beyond},
                      {Metric::kJointPositionMinMargin, below}};
  if (applies(Metric::kJointAccelerationMaxRatio, scenario))
    limits.push_back({Metric::kJointAccelerationMaxRatio, beyond});
  for (const Metric contact : kContactMetrics) {
    if (applies(contact, scenario)) limits.push_back({contact, below});
  }
  return limits;
}

std::string lost_limits(const RolloutResult& result, double share) {
  const bool abandoned = result.status == RolloutStatus::kHopeless;
  if (result.status != RolloutStatus::kCompleted && !abandoned) return result.reason;
  const Metrics& metrics = result.metrics;
  if (metrics[Metric::kJointPositionMinMargin] < 0.0) return "a joint leaves its position limits";
  if (const std::string contact = contact_text(metrics); !contact.empty()) return "the arm " + contact;
  if (metrics[Metric::kJointVelocityMaxRatio] > share) {
    return fmt::format("the velocity of {} exceeds {} of its limit", metrics.max_ratio_joint, share);
  }
  if (metrics[Metric::kJointAccelerationMaxRatio] > share)
    return fmt::format("the acceleration of a joint exceeds {} of its limit", share);
  return fmt::format("a commanded torque exceeds {} of the joint's effort limit", share);
}

}  // namespace armtune::internal
