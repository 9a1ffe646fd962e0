#pragma once
// Tests whether a rollout stays within a given fraction of the arm's velocity and effort limits, and names
// the limit that it breaks. Gains for a first task must leave a reserve below these limits.

#include <string>

#include "sim/rollout/end_limit.hpp"
#include "sim/rollout/rollout_result.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// Largest share of a joint's velocity and effort limits that the arm may use in a first task. The study of
/// the task has the same limit.
inline constexpr double kFirstTaskRatio = 0.9;

/// True if the rollout completed with at most `share` of the velocity and effort limits, inside the position
/// limits, and without contact.
bool keeps_limits(const RolloutResult& result, double share);

/// Returns the limits at which keeps_limits becomes false, so that a rollout can be abandoned there.
EndLimits ends_of_kept_limits(const Scenario& scenario, double share);

/// Returns which limit a rollout broke, or why it ended early, as a clause. keeps_limits must be false for
/// the rollout.
std::string lost_limits(const RolloutResult& result, double share);

}  // namespace armtune::internal
