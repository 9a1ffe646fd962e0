// The controller that is tuned is chosen from files as packages publish them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sim/controller_files/ros_controllers.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace chosen_controller_test {

using test::refused_at;
using testing::UnorderedElementsAre;

const std::vector<std::string> kArm = {"j1", "j2"};

std::string trajectory(const std::string& name, const std::string& commands,
                       const std::vector<std::string>& joints) {
  std::string text = name + ":\n  ros__parameters:\n    command_interfaces: [" + commands + "]\n    gains:\n";
  for (const std::string& joint : joints) text += "      " + joint + ": {p: 100.0, d: 1.0}\n";
  return text;
}

/// The list of a controller manager with the types of these controllers.
constexpr const char* kManager = R"(controller_manager:
  ros__parameters:
    update_rate: 1000
    arm: {type: joint_trajectory_controller/JointTrajectoryController}
    joint_state_broadcaster: {type: joint_state_broadcaster/JointStateBroadcaster}
    own: {type: my_package/MyController}
)";

RosController chosen(const std::string& text, const std::vector<std::string>& joints = kArm) {
  return chosen_controller(ros_controllers(text, "f.yaml"), "f.yaml", "", joints);
}

// As in the files of Universal Robots, Kinova and Franka for ros2_control: one controller has gains.
TEST(ChosenController, IsTheOneWithGainsBesideBroadcastersAndControllersOfOtherTypes) {
  const std::string own = "own:\n  ros__parameters:\n    gains:\n      j1: {p: 3.0}\n      j2: {p: 3.0}\n";
  const RosController arm = chosen(kManager + own + trajectory("arm", "effort", kArm));
  EXPECT_EQ(arm.name, "arm");
  EXPECT_THAT(arm.neighbours, UnorderedElementsAre("joint_state_broadcaster", "own"));
  EXPECT_THAT(chosen(trajectory("arm", "effort", kArm)).neighbours, testing::IsEmpty());
}

TEST(ChosenController, IsNotOneWhoseCommandsAreNotSimulated) {
  const std::string text = trajectory("position_arm", "position", kArm) +
                           trajectory("both_arm", "position, velocity", kArm) +
                           trajectory("velocity_arm", "velocity", kArm);
  EXPECT_EQ(chosen(text).name, "velocity_arm");
  const std::string ros1 =
      "pos:\n  type: position_controllers/JointTrajectoryController\n  gains: {j1: {p: 1.0}, j2: {p: 1.0}}\n"
      "eff:\n  type: effort_controllers/JointTrajectoryController\n  gains: {j1: {p: 1.0}, j2: {p: 1.0}}\n";
  EXPECT_EQ(chosen(ros1).name, "eff");
}

// Grippers, and the other arm of a robot with two.
TEST(ChosenController, IsTheOneForTheJointsOfTheArm) {
  const std::string text = trajectory("gripper", "effort", {"finger"}) +
                           trajectory("left", "effort", {"left_j1", "left_j2"}) +
                           trajectory("right", "effort", {"$(var prefix)j1", "$(var prefix)j2"});
  EXPECT_EQ(chosen(text).name, "right");
  EXPECT_EQ(chosen(text, {"left_j2", "left_j1"}).name, "left");
  EXPECT_EQ(chosen(text, {"finger"}).name, "gripper");
  // Without the arm's joints, all three are possible.
  EXPECT_THAT([&] { chosen(text, {}); },
              refused_at({.file = "f.yaml", .value = "3", .limit = "one of: gripper, left, right"}));
}

TEST(ChosenController, IsAskedForIfSeveralCanBeTuned) {
  const std::string text = trajectory("fast", "effort", kArm) + trajectory("slow", "velocity", kArm) +
                           trajectory("other", "position", kArm);
  EXPECT_THAT([&] { chosen(text); },
              refused_at({.file = "f.yaml", .value = "2", .limit = "one of: fast, slow"}));
  EXPECT_EQ(chosen_controller(ros_controllers(text, "f.yaml"), "f.yaml", "slow", kArm).name, "slow");
  EXPECT_THAT([&] { chosen_controller(ros_controllers(text, "f.yaml"), "f.yaml", "slo", kArm); },
              refused_at({.file = "f.yaml", .value = "slo", .limit = "one of: fast, slow, other"}));
}

// If none can be tuned, but only one is there, its reader says what is wrong with it.
TEST(ChosenController, IsTheOnlyOneEvenIfItCannotBeTuned) {
  EXPECT_EQ(chosen(trajectory("arm", "position", kArm)).name, "arm");
  EXPECT_EQ(chosen(trajectory("arm", "effort", {"j1"})).name, "arm");
  EXPECT_THAT([&] { chosen(trajectory("a", "position", kArm) + trajectory("b", "position", kArm)); },
              refused_at({.file = "f.yaml", .value = "2", .limit = "one of: a, b"}));
}

// As in Franka's files with several examples.
TEST(ChosenController, IsTheJointImpedanceControllerOfAKnownType) {
  const auto impedance = [](const std::string& name, const std::string& type, const std::string& numbers) {
    return name + ":\n  ros__parameters:\n    type: " + type + "\n    k_gains: " + numbers +
           "\n    d_gains: " + numbers + "\n";
  };
  const std::string known = "franka_example_controllers/JointImpedanceExampleController";
  const std::string text = impedance("own", "my_package/Impedance", "[1.0, 1.0]") +
                           impedance("left", known, "[1.0, 1.0, 1.0]") +
                           impedance("example", known, "[1.0, 1.0]");
  EXPECT_EQ(chosen(text).name, "example");
  EXPECT_EQ(chosen(text + trajectory("arm", "effort", kArm)).name, "arm") << "comes first";
  EXPECT_EQ(chosen(text + trajectory("arm", "position", kArm)).name, "example") << "not tunable";
}

}  // namespace chosen_controller_test
}  // namespace armtune::internal
