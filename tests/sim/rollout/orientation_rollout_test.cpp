// Rollouts whose tool is turned as the scenario says, rather than at a target.

#include <gtest/gtest.h>

#include <cmath>

#include "core/trajectory/rotation.hpp"
#include "sim/lanes/rollout_lanes.hpp"
#include "sim/rollout/columns.hpp"
#include "tests/core/support/allocation_counter.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace orientation_rollout_test {

/// A figure eight of the UR10 in 10 s with its arm known, or as it is with noise, delay and payload.
Scenario drawing(const std::string& orientation, const std::string& more = "") {
  const test::TemporaryFolder folder;
  // Down, then tilted one way and the other.
  folder.write("poses.csv",
               "time,qw,qx,qy,qz\n0,0,0.7071067811865476,0.7071067811865476,0\n"
               "6,0.1,0.7,0.7,0.1\n11,0,0.8,0.6,0\n16,0,0.7071067811865476,0.7071067811865476,0\n");
  return load_scenario(
      folder.write("drawing.yaml",
                   "robot: ur10\nduration: 16\ncontrol_period: 0.002\ntheta_start: {model_scale: 1}\n"
                   "path: {figure_eight: {center: [-0.65, 0.04, 0.5], length: [0.12, 0, 0], width: [0, 0.06, "
                   "0], period: 10}}\n"
                   "orientation: " +
                       orientation + "\n" + more));
}

Gains gains_of(const Scenario& scenario, const char* set = "extended_tuned") {
  Gains gains = load_gains(set, joint_names(*scenario.robot));
  gains.joint_space_goal.resize(0);
  gains.joint_trajectory_duration = 3.0;
  return with_goal(gains, scenario);
}

class OrientationRollout : public testing::TestWithParam<const char*> {};

TEST_P(OrientationRollout, HoldsWhatIsWanted) {
  const Scenario scenario = drawing(GetParam());
  int tracked = 0;
  const RolloutResult result =
      Rollout(scenario, Stepper::kMidpoint, Engine::kNative)
          .run(gains_of(scenario), [&](const Observation& o) {
            if (o.time < 8.0) return true;
            ++tracked;
            const Mat3 wanted =
                scenario.orientation->at(o.time, scenario.path).orientation.toRotationMatrix();
            EXPECT_LT((o.poses->R_0T - wanted).norm(), 2e-3) << o.time;
            EXPECT_NEAR(o.gaze_angle,
                        rotation_log(Eigen::Quaterniond(wanted * o.poses->R_0T.transpose())).norm(), 1e-9);
            return true;
          });
  ASSERT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
  EXPECT_GT(tracked, 3000);
  EXPECT_LT(result.metrics[Metric::kPositionRms], 1e-3);
  EXPECT_LT(result.metrics[Metric::kOrientationRms], 1e-3);
  EXPECT_LT(result.metrics[Metric::kGazeRateErrorRms], 0.1);
}

TEST_P(OrientationRollout, IsTheSameInSimbody) {
  Scenario scenario = drawing(GetParam());
  scenario.duration = 6.0;
  const Gains gains = gains_of(scenario);
  EXPECT_LT(
      test::largest_difference(test::joint_path(scenario, gains, Stepper::kRungeKutta4, Engine::kNative),
                               test::joint_path(scenario, gains, Stepper::kRungeKutta4)),
      1e-7);
}

TEST_P(OrientationRollout, InALaneIsTheOneAloneToTheBit) {
  const auto prepared = std::make_shared<const PreparedScenario>(drawing(
      GetParam(),
      "plant: {position_noise: 1.0e-4, torque_delay_periods: 1, payload: {mass: 1, center: [0, 0, 0.1]}}\n"));
  const Gains gains = gains_of(prepared->scenario);
  const RolloutResult alone = Rollout(prepared->scenario, Stepper::kMidpoint, Engine::kNative).run(gains);
  RolloutLanes lanes(lane_kind(prepared->scenario, Stepper::kMidpoint, 0), 2);
  lanes.start(0, {prepared, gains});
  lanes.start(1, {prepared, gains_of(prepared->scenario, "published")});
  RolloutResult beside;
  const RolloutLanes::Finished finished = [&](int lane, RolloutResult&& result) {
    if (lane == 0) beside = std::move(result);
  };
  lanes.step(finished);
  const long first = test::allocations();
  for (int k = 2; k < 3000; ++k) lanes.step(finished);
  if (test::allocations_are_counted()) {
    EXPECT_EQ(test::allocations(), first);
  }
  while (lanes.busy() > 0) lanes.step(finished);
  EXPECT_EQ(test::bits(beside.metrics), test::bits(alone.metrics));
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, OrientationRollout,
    testing::Values("{rpy_deg: [180, 0, 90]}", "{along_path: [0, 0, -1]}", "{waypoints: poses.csv}"),
    [](const auto& kind) {
      return std::string(kind.index == 0 ? "Fixed" : kind.index == 1 ? "AlongThePath" : "ThroughWaypoints");
    });

TEST(OrientedTool, OfAnAxisTheRollIsNoError) {
  const Scenario scenario = drawing("{rpy_deg: [180, 0, 90]}", "task_mask: position_and_axis\n");
  const RolloutResult result = Rollout(scenario, Stepper::kMidpoint, Engine::kNative)
                                   .run(gains_of(scenario), [&](const Observation& o) {
                                     if (o.time > 8.0) {
                                       EXPECT_LT((o.poses->R_0T.col(2) + Vec3::UnitZ()).norm(), 2e-3);
                                       EXPECT_NEAR(o.error.tail<3>().dot(o.poses->R_0T.col(2)), 0.0, 1e-9);
                                     }
                                     return true;
                                   });
  ASSERT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
  EXPECT_LT(result.metrics[Metric::kOrientationRms], 1e-3);
}

TEST(OrientedTool, TheTargetsColumnsAreEmpty) {
  Scenario scenario = drawing("{rpy_deg: [180, 0, 90]}");
  scenario.duration = 4.0;
  const auto columns = rollout_columns(scenario);
  int found = 0;
  Rollout(scenario, Stepper::kMidpoint, Engine::kNative).run(gains_of(scenario), [&](const Observation& o) {
    for (const Column& column : columns) {
      if (!column.name.starts_with("target/position")) continue;
      ++found;
      EXPECT_TRUE(std::isnan(column.value(o)));
    }
    return true;
  });
  EXPECT_GT(found, 0);
}

}  // namespace orientation_rollout_test
}  // namespace armtune::internal
