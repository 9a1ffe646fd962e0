#pragma once
// Bounds on metrics that a gain set must keep on every arm.

#include <string>
#include <vector>

#include "sim/rollout/rollout.hpp"

namespace armtune::internal {

struct MetricLimit {
  Metric metric = Metric::kJointVelocityMaxRatio;
  bool upper = true;  ///< true: at most `value`; false: at least
  double value = 1.0;
};

/// Largest share of a scenario's control periods that may have a saturated joint. An unstable loop chatters
/// from torque bound to torque bound long before it diverges or tracks much worse.
inline constexpr double kSaturatedShare = 0.01;
/// Returns this share as a number of the scenario's periods.
inline long saturated_periods_allowed(const Scenario& scenario) {
  return static_cast<long>(kSaturatedShare * scenario.periods());
}
/// Returns "torque saturated in over 1 % of the periods".
std::string saturation_text();

/// Returns the arm's own limits: joint velocities and positions inside their limits, and no contact with an
/// obstacle, another link, the cell or the floor.
std::vector<MetricLimit> arm_limits();

/// Reads a limit such as "joint_velocity/max_ratio<=0.9" or one with ">=". Throws InputError.
MetricLimit parse_limit(const std::string& text);

/// Reads the limits given as texts; without any, returns the arm's own. Throws InputError.
std::vector<MetricLimit> parse_limits(const std::vector<std::string>& texts);

/// Returns a text such as "joint_velocity/max_ratio <= 0.9".
std::string to_string(const MetricLimit& limit);

/// Returns the first limit that a result breaks, or that its torque saturates in too many periods. For a
/// result that did not complete it is its status. The text is empty if all is kept. A metric without a value
/// breaks its limit if it applies to the scenario, and none otherwise.
std::string broken_limit(const RolloutResult& result, const std::vector<MetricLimit>& limits,
                         const Scenario& scenario);

}  // namespace armtune::internal
