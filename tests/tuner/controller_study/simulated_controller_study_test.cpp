// Rollouts of studies whose controllers command velocities, or jump from point to point.

#include "tuner/controller_study/controller_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/rollout/rollout.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/support/joint_trajectory_example.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace simulated_controller_study_test {

using testing::Contains;
using testing::HasSubstr;

using test::changed_example;
using test::example;
using test::refused_at;

/// A p of 5 and the whole desired velocity for each joint of the UR5e.
std::string velocity_gains() {
  std::string text;
  for (const std::string& joint : joint_names(*load_robot("ur5e")))
    text += "      " + joint + ": {p: 5.0, i: 0.0, d: 0.0, ff_velocity_scale: 1.0}\n";
  return text;
}

// The desired positions of such a controller are those of the points alone.
TEST(ControllerStudy, OfAControllerThatDoesNotInterpolateJumpsFromPointToPoint) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.controllers = folder.write(
      "none.yaml",
      changed_example("    gains:   # set by hand", "    interpolation_method: none\n    gains:"));
  EXPECT_THAT([&] { write_controller_study(inputs, folder / "none"); },
              refused_at({.file = HasSubstr("moves.csv"), .key = "velocities"}))
      << "ROS reads a velocity of each point";
  inputs.trajectories = {folder.write(
      "steps.yaml",
      "joint_names: [shoulder_pan_joint, shoulder_lift_joint, elbow_joint, wrist_1_joint, wrist_2_joint, "
      "wrist_3_joint]\npoints:\n"
      "- {positions: [0, -1.5, 1, 0, 0, 0], velocities: [0, 0, 0, 0, 0, 0], time_from_start: 0}\n"
      "- {positions: [0.01, -1.5, 1, 0, 0, 0], velocities: [0, 0, 0, 0, 0, 0], time_from_start: 0.5}\n"
      "- {positions: [0.02, -1.5, 1, 0, 0, 0], velocities: [0, 0, 0, 0, 0, 0], time_from_start: 1}\n")};
  const ControllerStudyFiles files = write_controller_study(inputs, folder / "made").value();
  EXPECT_THAT(files.notes, Contains(HasSubstr("interpolation_method: none")));
  const Study study = load_study(files.study);
  const Scenario& scenario = study.scenarios.front();
  EXPECT_EQ(scenario.start_position[0], 0.0);
  EXPECT_EQ(scenario.planned->at(0.25).position[0], 0.01);
  EXPECT_EQ(scenario.planned->at(0.75).position[0], 0.02);
  const RolloutResult result = Rollout(scenario, Stepper::kMidpoint, Engine::kNative).run(study.space.start);
  EXPECT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
  EXPECT_GE(result.metrics[Metric::kJointErrorMax], 0.0099) << "the step of the desired position";
}

// Industrial arms: the drives have the damping.
TEST(ControllerStudy, OfVelocityCommandsIsOfThatKind) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.controllers = folder.write("v.yaml",
                                    "controller_manager: {ros__parameters: {update_rate: 500}}\n"
                                    "arm_controller:\n  ros__parameters:\n"
                                    "    type: joint_trajectory_controller/JointTrajectoryController\n"
                                    "    command_interfaces: [velocity]\n    gains:\n" +
                                        velocity_gains());
  const Study study = load_study(write_controller_study(inputs, folder / "a").value().study);
  EXPECT_EQ(study.space.start.controller, "joint_trajectory_controller_velocity");
  EXPECT_EQ(study.space.free.size(), 6U) << "p alone";
  const RolloutResult result =
      Rollout(study.scenarios.front(), Stepper::kMidpoint, Engine::kNative).run(study.space.start);
  EXPECT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
  EXPECT_LT(result.metrics[Metric::kJointErrorMax], 0.05);
  const RolloutResult judged =
      Rollout(study.scenarios.front(), Stepper::kMidpoint, Engine::kSimbody).run(study.space.start);
  for (const Metric metric : {Metric::kJointErrorMax, Metric::kJointErrorRms, Metric::kJointEffortMaxRatio})
    EXPECT_NEAR(result.metrics[metric], judged.metrics[metric], 1e-9) << name(metric);
}

}  // namespace simulated_controller_study_test
}  // namespace armtune::internal
