#pragma once
// Limits of metrics. Gains must keep them on random arms, and in the rollouts that find stability margins.

#include <optional>
#include <string>
#include <vector>

#include "sim/rollout/rollout.hpp"

namespace armtune::internal {

struct MetricLimit {
  Metric metric = Metric::kJointVelocityMaxRatio;
  bool upper = true;  ///< true: the metric must be at most `value`; false: at least `value`
  double value = 1.0;
};

/// Largest allowed share of control periods in which the torque of a joint saturates. The torque of an
/// unstable loop chatters between its limits long before the loop diverges or its tracking error becomes much
/// larger.
inline constexpr double kSaturatedShare = 0.01;
/// Returns the largest allowed number of such control periods in the scenario.
inline long saturated_periods_allowed(const Scenario& scenario) {
  return static_cast<long>(kSaturatedShare * scenario.periods());
}
/// Returns "torque saturated in over 1 % of the periods".
std::string saturation_text();

/// Returns the arm's own limits. Joint positions, velocities and, if the robot file limits them,
/// accelerations stay within their limits. The arm touches no obstacle, nor itself, the cell or the floor.
std::vector<MetricLimit> arm_limits();

/// Returns the limit that a text such as "joint_velocity/max_ratio<=0.9" describes. The relation is "<=" or
/// ">=". Throws InputError for any other text.
MetricLimit parse_limit(const std::string& text);

/// Returns the limits that the texts describe, or arm_limits() if there are no texts. Throws InputError.
std::vector<MetricLimit> parse_limits(const std::vector<std::string>& texts);

/// Returns a text such as "joint_velocity/max_ratio <= 0.9".
std::string to_string(const MetricLimit& limit);

/// The reason why a rollout fails.
struct RolloutFailure {
  std::string text;              ///< empty: the rollout does not fail
  std::optional<Metric> metric;  ///< the metric whose limit is broken; empty for other reasons
};

/// Returns why a rollout fails. If it did not complete, the text is its status. Otherwise the text is the
/// first limit that it breaks, or saturation_text() if torques saturate in too many periods. A metric without
/// a value breaks its limit if the metric applies to the scenario. If it does not apply, its limit is
/// ignored.
RolloutFailure broken_limit(const RolloutResult& result, const std::vector<MetricLimit>& limits,
                            const Scenario& scenario);

}  // namespace armtune::internal
