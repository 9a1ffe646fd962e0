// Joint velocities in Simbody with the governor and the barrier, where the published law exceeds its limits.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/control/velocity_governor.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace velocity_limits_test {

using test::quick_gains;
using test::scenario_of;

Gains governed(Gains gains) {
  gains.velocity_margin = 0.85;
  gains.velocity_barrier_gain = 2.0;
  return gains;
}

Metrics run(const Scenario& scenario, const Gains& gains) {
  const RolloutResult result = Rollout(scenario, Stepper::kMidpoint).run(gains);
  EXPECT_NE(result.status, RolloutStatus::kDiverged) << result.reason;
  EXPECT_EQ(result.end_time, scenario.duration);
  return result.metrics;
}

/// Smallest distance of a joint origin, which is what the published law acts on [m].
double nearest_origin(const Scenario& scenario, const Gains& gains) {
  double nearest = HUGE_VAL;
  Rollout(scenario, Stepper::kMidpoint).run(gains, [&nearest](const Observation& o) {
    nearest = std::min(nearest, o.control->obstacle_distance);
    return true;
  });
  return nearest;
}

void record(const char* what, double off, double on) {
  testing::Test::RecordProperty(what, fmt::format("{:.3g} {:.3g}", off, on));
}

/// Beyond its limit with these gains, below it with governor and barrier.
void expect_held(const Scenario& scenario, const Gains& gains) {
  const Metrics off = run(scenario, gains);
  const Metrics on = run(scenario, governed(gains));
  record("joint_velocity/max_ratio", off[Metric::kJointVelocityMaxRatio], on[Metric::kJointVelocityMaxRatio]);
  record("reacquisition/time", off[Metric::kReacquisitionTime], on[Metric::kReacquisitionTime]);
  EXPECT_GT(off[Metric::kJointVelocityMaxRatio], 1.0) << "or the governor has nothing to do";
  EXPECT_LT(on[Metric::kJointVelocityMaxRatio], 1.0);
  EXPECT_LT(on[Metric::kReacquisitionTime], 0.5 * scenario.switch_every) << "the gaze still arrives";
}

TEST(VelocityLimits, HoldWhenASwitchOfTargetsIsToBeTooQuick) {
  const Scenario scenario = scenario_of("target_switch", 18.0);
  Gains gains = quick_gains(scenario);
  gains.slerpDurationErrorGain = 0.3;
  expect_held(scenario, gains);
}

TEST(VelocityLimits, HoldWithTheReleasedSlerpToo) {
  const Scenario scenario = scenario_of("target_switch", 18.0);
  Gains gains = quick_gains(scenario);
  gains.slerpDurationErrorGain = 0.3;
  gains.slerp_reference = SlerpReference::kCurrent;
  gains.slerp_start = 0.2;
  expect_held(scenario, gains);
}

TEST(VelocityLimits, AreLeftAloneByBothWhereThePublishedLawKeepsThem) {
  // The released slerp with the published duration among them: reaching 0.5 of the limit, nothing is slowed.
  for (const char* name : {"target_switch", "obstacle_pass"}) {
    const Scenario scenario = scenario_of(name, 18.0);
    Gains gains = quick_gains(scenario);
    gains.slerp_reference = SlerpReference::kCurrent;
    gains.slerp_start = 0.2;
    const Metrics off = run(scenario, gains);
    EXPECT_LT(off[Metric::kJointVelocityMaxRatio], kGovernorKnee * 0.85);
    EXPECT_EQ(test::bits(run(scenario, governed(gains))), test::bits(off)) << name;
  }
}

TEST(VelocityLimits, HoldForQuickReturnsFromObstaclesThatStayAsFarAway) {
  const Scenario scenario = scenario_of("obstacle_pass", 20.0);
  Gains gains = quick_gains(scenario);
  const double published = nearest_origin(scenario, gains);
  gains.trajectoryDurationErrorGain = 1.0;
  const Metrics off = run(scenario, gains);
  const Metrics on = run(scenario, governed(gains));
  record("obstacle/min_clearance", off[Metric::kObstacleMinClearance], on[Metric::kObstacleMinClearance]);
  record("joint_velocity/max_ratio", off[Metric::kJointVelocityMaxRatio], on[Metric::kJointVelocityMaxRatio]);
  EXPECT_GT(off[Metric::kJointVelocityMaxRatio], 1.0);
  EXPECT_LT(on[Metric::kJointVelocityMaxRatio], 1.0);
  EXPECT_LT(on[Metric::kObstacleMinClearance], gains.obstacleInfluenceRadius) << "an obstacle came near";
  // Slower returns meet the obstacle elsewhere: it may differ either way, by far less than the distance, and
  // of the origins, which alone are repelled, is no worse than with the published ones, which are slower
  // still.
  EXPECT_GE(nearest_origin(scenario, governed(gains)), published);
  EXPECT_GE(on[Metric::kObstacleMinClearance], off[Metric::kObstacleMinClearance] - 1e-3);
}

TEST(VelocityLimits, HoldAgainstARepulsionThatBypassesTheReference) {
  const Scenario scenario = scenario_of("obstacle_pass", 4.0);
  Gains gains = quick_gains(scenario);
  gains.obstacleInfluenceRadius = 0.6;
  gains.force_control_gains *= 30.0;  // as strong as the joints are
  Gains governor_alone = governed(gains);
  governor_alone.velocity_barrier_gain = 0.0;
  const Metrics off = run(scenario, gains);
  const Metrics governor = run(scenario, governor_alone);
  const Metrics on = run(scenario, governed(gains));
  record("joint_velocity/max_ratio", off[Metric::kJointVelocityMaxRatio], on[Metric::kJointVelocityMaxRatio]);
  record("obstacle/min_clearance", off[Metric::kObstacleMinClearance], on[Metric::kObstacleMinClearance]);
  EXPECT_GT(off[Metric::kJointVelocityMaxRatio], 1.0);
  EXPECT_GT(governor[Metric::kJointVelocityMaxRatio], 1.0) << "a torque is not a reference";
  EXPECT_LT(on[Metric::kJointVelocityMaxRatio], 1.0);
  EXPECT_GE(on[Metric::kObstacleMinClearance], off[Metric::kObstacleMinClearance]);
}

}  // namespace velocity_limits_test
}  // namespace armtune::internal
