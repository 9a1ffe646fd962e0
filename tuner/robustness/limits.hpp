#pragma once
// What a gain set must keep on every arm: bounds on metrics.

#include <string>
#include <vector>

#include "sim/rollout/rollout.hpp"

namespace armtune::internal {

struct MetricLimit {
  Metric metric = Metric::kJointVelocityMaxRatio;
  bool upper = true;  ///< at most, else at least
  double value = 1.0;
};

/// Largest share of a scenario's control periods that may have a saturated joint: an unstable loop chatters
/// from torque bound to torque bound, long before it diverges or tracks much worse.
inline constexpr double kSaturatedShare = 0.01;
/// How many periods of a scenario that is.
inline long saturated_periods_allowed(const Scenario& scenario) {
  return static_cast<long>(kSaturatedShare * scenario.periods());
}
/// "torque saturated in over 1 % of the periods"
std::string saturation_text();

/// The arm's own: joint velocities and positions inside their limits, and no obstacle touched.
std::vector<MetricLimit> arm_limits();

/// From "joint_velocity/max_ratio<=0.9" or ">=". Throws InputError.
MetricLimit parse_limit(const std::string& text);

/// Those given as text, or the arm's own where none are. Throws InputError.
std::vector<MetricLimit> parse_limits(const std::vector<std::string>& texts);

/// "joint_velocity/max_ratio <= 0.9"
std::string to_string(const MetricLimit& limit);

/// The first limit that a result breaks, or that its torque saturates in too many periods, or, if it did not
/// complete, its status; empty if it keeps them all. A metric without a value breaks its limit where it
/// applies to the scenario, and nothing elsewhere.
std::string broken_limit(const RolloutResult& result, const std::vector<MetricLimit>& limits,
                         const Scenario& scenario);

}  // namespace armtune::internal
