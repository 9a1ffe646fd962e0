#pragma once
// Whether a rollout keeps to a share of its arm's limits, and how it fails to.

#include <string>

#include "sim/rollout/end_limit.hpp"
#include "sim/rollout/rollout_result.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// The most of a joint's velocity and effort limits that a first task takes: what its study demands.
inline constexpr double kFirstTaskRatio = 0.9;

/// Whether it is completed, with at most `share` of the limits of velocity and effort, inside the position
/// limits, and without touching anything.
bool keeps_limits(const RolloutResult& result, double share);

/// Where keeps_limits is lost, and a rollout need not go on.
EndLimits ends_of_kept_limits(const Scenario& scenario, double share);

/// How a rollout for which keeps_limits is false fails, as a clause.
std::string lost_limits(const RolloutResult& result, double share);

}  // namespace armtune::internal
