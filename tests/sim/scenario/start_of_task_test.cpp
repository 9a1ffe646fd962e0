#include "sim/scenario/start_of_task.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/rollout/rollout.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tests/core/support/states.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace start_of_task_test {

using testing::HasSubstr;

Gains published(const Scenario& scenario) {
  return load_gains("published", joint_names(*scenario.robot));
}

TEST(StartOfTask, AScenarioWithoutAStartFindsItsOwnAndTheGoalOnTheTask) {
  const test::TemporaryFolder folder;
  const std::string text =
      "robot: ur10\nduration: 20\ncontrol_period: 0.002\n"
      "path: {center: [-0.65, 0.04, 0.5], frequency: 0.6, terms: [{order: 1, cos: [0, -0.12, 0], sin: "
      "[-0.12, 0, 0]}]}\n"
      "targets: [{name: below, center: [-0.6, 0, 0]}]\ntheta_start: {model_scale: 1}\n";
  const Scenario scenario = load_scenario(folder.write("own.yaml", text));
  const Poses poses = test::poses_at(scenario.robot->chain, scenario.goal_position);
  EXPECT_LT((poses.p_0T - scenario.path.at(0.0).position).norm(), 1e-8);
  EXPECT_LT(poses.R_0T.col(2).cross((scenario.targets[0].path.center - poses.p_0T).normalized()).norm(),
            1e-8);
  EXPECT_GT((scenario.start_position - scenario.goal_position).cwiseAbs().minCoeff(), 0.1);

  Gains gains = published(scenario);
  gains.joint_space_goal.resize(0);
  EXPECT_EQ(with_goal(gains, scenario).joint_space_goal, in_degrees(*scenario.robot, scenario.goal_position));
  const RolloutResult result = Rollout(scenario, Stepper::kMidpoint, Engine::kNative).run(gains);
  ASSERT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
  EXPECT_LT(result.metrics[Metric::kPositionMax], 2e-3);

  const Scenario given =
      load_scenario(folder.write("given.yaml", text + "start_position_deg: [0, -90, 90, 0, 0, 0]\n"));
  EXPECT_THAT([&] { with_goal(gains, given); }, test::refused_at({.file = folder / "given.yaml",
                                                                  .key = "start_position_deg",
                                                                  .limit = "joint_space_goal in the gains"}));
}

TEST(StartOfTask, WaypointsInMillimetresAreNamedAndOnesInMetresThatAreOutOfReachAreNot) {
  const test::TemporaryFolder folder;
  const auto load = [&](const std::string& rows, const std::string& units) {
    folder.write("moves.csv", "time,x,y,z\n" + rows);
    return load_scenario(folder.write(
        "own.yaml",
        "robot: ur10\nduration: 9\ncontrol_period: 0.002\npath: {waypoints: {file: moves.csv" + units +
            "}}\ntargets: [{name: below, center: [-0.6, 0, 0]}]\ntheta_start: {model_scale: 1}\n"));
  };
  const std::string millimetres = "0,-650,160,500\n5,-700,160,500\n9,-700,200,400\n";
  const InputError far = test::input_error([&] { load(millimetres, ""); });
  EXPECT_THAT(far,
              test::refused_at({.file = folder / "own.yaml", .key = "path", .value = "(-650, 160, 500)"}));
  EXPECT_THAT(far.what(), HasSubstr("units: {length: mm}"));
  EXPECT_LT(
      (load(millimetres, ", units: {length: mm}").path.at(0.0).position - Vec3(-0.65, 0.16, 0.5)).norm(),
      1e-12);
  const InputError metres = test::input_error([&] { load("0,-6.5,1.6,5\n9,-7,2,4\n", ""); });
  EXPECT_THAT(metres, test::refused_at({.key = "path", .value = "(-6.5, 1.6, 5)"}));
  EXPECT_THAT(metres.what(), testing::Not(HasSubstr("mm")));
}

TEST(StartOfTask, AGainsFileMayLeaveTheGoalOutAndReadsBackWithoutIt) {
  const Scenario scenario = load_scenario("moving_target");
  Gains gains = published(scenario);
  gains.joint_space_goal.resize(0);
  const test::TemporaryFolder folder;
  const std::string path = folder.write("gains.yaml", gains_yaml(gains, {}));
  EXPECT_EQ(load_gains(path, joint_names(*scenario.robot)).joint_space_goal.size(), 0);
}

TEST(StartOfTask, TheFoundStartIsOffTheGoalTowardsTheMiddle) {
  const Scenario scenario = load_scenario("moving_target");
  RobotModel arm = *scenario.robot;
  for (JointInfo& joint : arm.joints) joint.limits = {true, -2.0, 2.0, 1.0, 1.0};
  arm.joints[5].limits = {true, -0.1, 0.1, 1.0, 1.0};
  JointVector goal = JointVector::Constant(6, 1.9);
  goal[1] = -1.9;
  goal[5] = 0.09;
  const JointVector start = off_goal(arm, goal);
  EXPECT_NEAR(start[0], 1.9 - M_PI / 9.0, 1e-12);
  EXPECT_NEAR(start[1], -1.9 + M_PI / 9.0, 1e-12);
  EXPECT_NEAR(start[5], 0.07, 1e-12);
}

}  // namespace start_of_task_test
}  // namespace armtune::internal
