// The controller is not the UR10's: a redundant arm follows a circle and its target too.

#include <gtest/gtest.h>

#include <cmath>

#include "sim/rollout/rollout.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tests/core/support/arms.hpp"

namespace armtune::internal {
namespace other_arms_test {

constexpr double kDegree = M_PI / 180.0;

/// The seven-joint arm bent, its tool on a circle around where the joint space law leaves it, looking at a
/// point ahead of the tool.
struct SevenJoints {
  Scenario scenario;
  Gains gains;

  SevenJoints() {
    const auto model = std::make_shared<const RobotModel>(test::seven_joint_arm());
    const int n = model->n();
    JointVector goal(n);
    goal << 0.0, 40.0, 0.0, -80.0, 0.0, 50.0, 0.0;
    gains.joint_space_goal = goal;
    gains.joint_space_gains_p = JointVector::Constant(n, 5.0);
    gains.joint_space_gains_d = JointVector::Constant(n, 20.0);
    gains.task_space_gains_p << 40, 40, 40, 20, 20, 20;
    gains.task_space_gains_i << 0.1, 0.1, 0.1, 1, 1, 1;
    gains.task_space_gains_d = JointVector::Constant(n, 20.0);
    gains.force_control_gains = JointVector::Constant(n, 100.0);
    gains.joint_trajectory_duration = 2.0;
    gains.manipulability_threshold = 0.02;

    Poses poses;
    forward_kinematics(model->chain, JointVector(goal * kDegree), poses);
    scenario.name = "seven_joints";
    scenario.robot = model;
    scenario.duration = 8.0;
    scenario.control_period = 0.002;
    scenario.start_position = 0.8 * goal * kDegree;
    scenario.path = {poses.p_0T, 2.0 * M_PI / 6.0, 0.0, {{1, Vec3(0, 0, 0.05), Vec3(0, 0.05, 0)}}};
    scenario.targets = {{"ahead", {poses.p_0T + 0.5 * poses.R_0T.col(2), 0.0, 0.0, {}}}};
    scenario.theta.model_scale = 1.0;
  }
};

TEST(OtherArms, ASevenJointArmFollowsItsCircleAndLooksAtItsTarget) {
  const SevenJoints arm;
  const RolloutResult result = Rollout(arm.scenario, Stepper::kMidpoint).run(arm.gains);
  ASSERT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
  EXPECT_LT(result.metrics[Metric::kPositionMax], 2e-3);
  EXPECT_LT(result.metrics[Metric::kOrientationMax], 2e-2);
  EXPECT_LT(result.metrics[Metric::kJointVelocityMaxRatio], 1.0);
}

TEST(OtherArms, CenteringKeepsJointsNearTheirMiddleAndTheToolOnItsPath) {
  SevenJoints arm;
  arm.gains.joint_space_goal << 60.0, 40.0, -70.0, -80.0, 60.0, 50.0, 0.0;
  Poses poses;
  forward_kinematics(arm.scenario.robot->chain, JointVector(arm.gains.joint_space_goal * kDegree), poses);
  arm.scenario.start_position = 0.8 * arm.gains.joint_space_goal * kDegree;
  arm.scenario.path.center = poses.p_0T;
  arm.scenario.targets[0].path.center = poses.p_0T + 0.5 * poses.R_0T.col(2);
  arm.scenario.duration = 12.0;
  double away[2];
  for (const bool centering : {false, true}) {
    arm.gains.joint_centering_gain = centering ? 0.5 : 0.0;
    JointVector q;
    const RolloutResult result =
        Rollout(arm.scenario, Stepper::kMidpoint).run(arm.gains, [&](const Observation& o) {
          q = *o.q;
          return true;
        });
    ASSERT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
    EXPECT_LT(result.metrics[Metric::kPositionMax], 2e-3);
    EXPECT_LT(result.metrics[Metric::kOrientationMax], 2e-2);
    away[centering] = q.norm();  // its limits lie about zero
  }
  EXPECT_LT(away[1], 0.95 * away[0]);
}

RolloutResult rollout(const char* scenario_name, const char* gains) {
  const Scenario scenario = load_scenario(scenario_name);
  return Rollout(scenario, Stepper::kMidpoint, Engine::kNative)
      .run(load_gains(gains, joint_names(*scenario.robot)));
}

TEST(OtherArms, SevenJointsFollowTheirTaskBetterTunedAndKeepOffTheirLimits) {
  // On the realistic arm, for which they were tuned, and on others like it.
  const RolloutResult start = rollout("panda_realistic_moving_target", "panda");
  const RolloutResult tuned = rollout("panda_realistic_moving_target", "panda_tuned");
  for (const Metric metric :
       {Metric::kPositionMax, Metric::kPositionRms, Metric::kOrientationMax, Metric::kOrientationRms}) {
    EXPECT_LT(tuned.metrics[metric], 0.5 * start.metrics[metric]) << name(metric);
  }
  EXPECT_LT(tuned.metrics[Metric::kPositionMax], 2e-3);
  for (const char* scenario : {"panda_moving_target", "panda_target_switch", "panda_obstacle_pass"}) {
    const RolloutResult result = rollout(scenario, "panda_tuned");
    EXPECT_GT(result.metrics[Metric::kJointPositionMinMargin], 0.1) << scenario;
    EXPECT_LT(result.metrics[Metric::kJointVelocityMaxRatio], 0.9) << scenario;
  }
}

TEST(OtherArms, FiveJointsFollowPositionAndGaze) {
  for (const char* scenario : {"youbot_moving_target", "youbot_target_switch"}) {
    const RolloutResult result = rollout(scenario, "youbot_tuned");
    ASSERT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
    EXPECT_LT(result.metrics[Metric::kPositionMax], 2e-3) << scenario;
    EXPECT_LT(result.metrics[Metric::kOrientationMax], 1e-2) << scenario;
    EXPECT_GT(result.metrics[Metric::kJointPositionMinMargin], 0.05) << scenario;
    EXPECT_LT(result.metrics[Metric::kJointVelocityMaxRatio], 0.9) << scenario;
  }
}

}  // namespace other_arms_test
}  // namespace armtune::internal
