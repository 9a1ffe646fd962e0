// A ROS parameter file is read as ROS reads it, refused where it asks for what is not simulated, and changed
// in its numbers alone.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/joint_trajectory_law.hpp"
#include "sim/controller_files/changed_gains.hpp"
#include "sim/controller_files/joint_trajectory_file.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/trajectory_file.hpp"
#include "tests/sim/support/without_numbers.hpp"

namespace armtune::internal {
namespace controller_file_test {

using test::refused;
using test::refused_at;
using test::with_j1;
using testing::HasSubstr;

TEST(ControllerFile, WhatIsNotSimulatedIsRefusedAtItsLine) {
  const std::vector<std::string> j1 = {"j1"};
  EXPECT_THAT(
      refused(with_j1("p: 1.0", "position"), j1),
      refused_at(
          {.file = "f.yaml", .line = 3, .key = "c", .value = "position", .limit = "effort or velocity"}));
  EXPECT_THAT(refused(with_j1("p: 1.0", "position, velocity"), j1),
              refused_at({.line = 3, .value = "position, velocity"}));
  EXPECT_THAT(
      refused("c:\n  type: position_controllers/JointTrajectoryController\n  gains: {j1: {p: 1.0}}\n", j1),
      refused_at({.line = 2, .value = "position_controllers/JointTrajectoryController"}));
  EXPECT_THAT(
      refused("c:\n  ros__parameters:\n    open_loop_control: true\n    command_interfaces: [velocity]\n"
              "    gains: {j1: {p: 1.0}}\n",
              j1),
      refused_at({.line = 3, .value = "true", .limit = "false"}));
  EXPECT_THAT(refused(with_j1("p: 1.0, i: 2.0"), j1),
              refused_at({.line = 6, .key = "c", .limit = "i_clamp or --distro"}));
  EXPECT_THAT(refused(with_j1("p: 1.0, i_clamp_max: 2.0, i_clamp_min: 0.0"), j1),
              refused_at({.line = 6, .value = "[0, 2]", .limit = "i_clamp_min below 0"}));
  EXPECT_THAT(refused(with_j1("p: 1.0, u_clamp_max: -2.0"), j1),
              refused_at({.line = 6, .value = "[-inf, -2]", .limit = "a range that contains 0"}));
  EXPECT_THAT(refused(with_j1("p: 1.0, antiwindup_strategy: nothing"), j1),
              refused_at({.line = 6, .value = "nothing", .limit = HasSubstr("back_calculation")}));
  EXPECT_THAT(refused(with_j1("p: \"1.0\""), j1),
              refused_at({.line = 6, .value = "1.0", .limit = HasSubstr("without quotes")}));
  EXPECT_THAT(refused(with_j1("p: .inf"), j1),
              refused_at({.line = 6, .value = ".inf", .limit = "a finite number"}));
  EXPECT_THAT(refused(with_j1("p: --1"), j1),
              refused_at({.line = 6, .value = "--1", .limit = HasSubstr("plain number")}));
  EXPECT_THAT(refused(with_j1("p: 1.0")), refused_at({.line = 6, .key = "c", .limit = "j2, j3"}));
  EXPECT_THAT(refused(with_j1("p: 1.0"), {"j_1"}),
              refused_at({.line = 6, .value = "j1", .limit = "one of: j_1"}));
  EXPECT_THAT(refused("a: 1\n"), refused_at({.file = "f.yaml", .line = 0}));
  for (const char* text : {"a: {b: 1}\n---\nc: 2\n", "a: 1\na: 2\n"})
    EXPECT_THAT(refused(text), refused_at({.file = "f.yaml", .line = 2})) << text;
  for (const char* text : {"a: 'b\n", "a: {b: 1\n"})
    EXPECT_THAT(refused(text), refused_at({.file = "f.yaml", .line = testing::Gt(0)})) << text;
}

TEST(ControllerFile, OnlyTextsWithAKeyOfThatNameAreTakenForSome) {
  for (const char* text :
       {"gains: 1", "a:\n  gains:\n", "{a: {gains: {}}}", "'gains': 1", "a: {b: 1,gains: 2}", "gains : 1"})
    EXPECT_TRUE(may_hold_controllers(text)) << text;
  for (const char* text :
       {"# gains: runs/tuned\na: 1", "joint_space_gains_p: [1]", "gains_p: 1", "a: gains", "againsts:", ""})
    EXPECT_FALSE(may_hold_controllers(text)) << text;
}

TEST(ControllerFile, IsReadAsRosReadsIt) {
  const std::vector<std::string> j1 = {"j1"};
  const auto read = [&j1](const std::string& text) {
    return joint_trajectory_gains(chosen_controller(ros_controllers(text, "f.yaml"), "f.yaml"), "f.yaml", j1);
  };
  const auto ros1 = [](const std::string& gains) {
    return "c:\n  type: effort_controllers/JointTrajectoryController\n  velocity_ff: {j1: 3.0}\n  gains: {j1: {" +
           gains + "}}\n";
  };
  EXPECT_EQ(own(read(ros1("p: 1.0")), "jtc_antiwindup")[0], 0.0);
  EXPECT_EQ(own(read(ros1("p: 1.0, antiwindup: true")), "jtc_antiwindup")[0], 1.0);
  EXPECT_EQ(own(read(with_j1("p: 1.0, antiwindup: false")), "jtc_antiwindup")[0], 1.0)
      << "no parameter of ROS 2";
  EXPECT_EQ(own(read(ros1("p: 1.0, ff_velocity_scale: 2.0")), "jtc_ff_velocity_scale")[0], 3.0);
  EXPECT_EQ(own(read(with_j1("p: 1.0, ff_velocity_scale: 2.0")), "jtc_ff_velocity_scale")[0], 2.0);
  EXPECT_EQ(own(read(ros1("p: 1.0, i_clamp: -4.0")), "jtc_i_clamp")[0], 4.0) << "ROS 1 takes its size";
  EXPECT_THAT(refused(ros1("p: 1.0, antiwindup: yes"), j1),
              refused_at({.line = 4, .value = "yes", .limit = "true or false"}));
  EXPECT_THAT(refused(ros1("p: 3e2"), j1),
              refused_at({.line = 4, .value = "3e2", .limit = HasSubstr("point before an exponent")}));
  EXPECT_THAT(refused(ros1("p: 010"), j1),
              refused_at({.line = 4, .value = "010", .limit = HasSubstr("leading zeros")}));
  EXPECT_THAT(refused(with_j1("p: 1.0, i_clamp: -4.0"), j1),
              refused_at({.line = 6, .value = "[4, -4]", .limit = "a range that contains 0"}));
  EXPECT_THAT(refused(with_j1("p: 1.0, error_deadband: -0.1"), j1),
              refused_at({.line = 6, .value = "-0.1", .limit = "0 or more"}));
  EXPECT_THAT(refused(with_j1("p: 1.0, angle_wraparound: true"), j1),
              refused_at({.line = 6, .value = "true", .limit = "false"}));
  EXPECT_THAT(refused("c:\n  ros__parameters:\n    joints: [j1]\n    gains: {j1: {p: 2.0}}\n", j1),
              refused_at({.line = 3, .limit = "[effort] or [velocity]"}));
}

TEST(ControllerFile, LimitsOfTheOutputAndStrategiesOfAntiWindupAreRead) {
  const auto read = [](const std::string& text) {
    return joint_trajectory_gains(chosen_controller(ros_controllers(text, "f.yaml"), "f.yaml"), "f.yaml",
                                  {"j1"});
  };
  const Gains given = read(
      with_j1("p: 1.0, i: 2.0, u_clamp_max: 7.0, u_clamp_min: -3.0, antiwindup_strategy: back_calculation, "
              "tracking_time_constant: 0.4, error_deadband: 0.01"));
  EXPECT_EQ(own(given, "jtc_u_clamp_max")[0], 7.0);
  EXPECT_EQ(own(given, "jtc_u_clamp_min")[0], 3.0);
  EXPECT_EQ(own(given, "jtc_tracking_time")[0], 0.4);
  EXPECT_EQ(own(given, "jtc_error_deadband")[0], 0.01);
  EXPECT_EQ(own(given, "jtc_i_clamp")[0], 1e6) << "a strategy is of Jazzy, which clamps nothing by default";
  double number = 1.0;
  for (const char* strategy : {"legacy", "none", "conditional_integration", "back_calculation"}) {
    const Gains gains = read(with_j1(fmt::format("p: 1.0, antiwindup_strategy: {}", strategy)));
    EXPECT_EQ(own(gains, "jtc_antiwindup")[0], number++) << strategy;
  }
  const Gains none = read(with_j1("p: 1.0, u_clamp_max: .inf", "velocity"));
  EXPECT_EQ(own(none, "jtc_velocity_u_clamp_max")[0], 1e6);
  EXPECT_EQ(own(none, "jtc_velocity_u_clamp_min")[0], 1e6);
  EXPECT_EQ(own(none, "jtc_velocity_error_deadband")[0], 0.0);
}

TEST(ControllerFile, BoundsOfTheIntegralMayDiffer) {
  const std::vector<std::string> j1 = {"j1"};
  const std::string text = with_j1("p: 1.0, i: 1.0, i_clamp_max: 2.0, i_clamp_min: -1.0");
  const RosController controller = chosen_controller(ros_controllers(text, "f.yaml"), "f.yaml");
  Gains gains = joint_trajectory_gains(controller, "f.yaml", j1);
  EXPECT_EQ(own(gains, "jtc_i_clamp")[0], 2.0);
  EXPECT_EQ(jtc_lower_i_clamp(gains, 0), 1.0);
  EXPECT_EQ(with_gains(text, controller, "f.yaml", gains, j1), text);
  own(gains, "jtc_i_clamp")[0] = 3.0;
  own(gains, "jtc_i_clamp_min")[0] = 1.5;
  EXPECT_THAT(with_gains(text, controller, "f.yaml", gains, j1),
              HasSubstr("i_clamp_max: 3.0, i_clamp_min: -1.5"));
}

// Node names may come several times, as in Franka's fr3_ros_controllers.yaml, which ROS 2 reads.
TEST(ControllerFile, TheSameNodeNameMayComeSeveralTimes) {
  const std::string text =
      "/**:\n  controller_manager:\n    ros__parameters: {update_rate: 1000}\n/**:\n  arm:\n    ros__parameters:\n"
      "      type: joint_trajectory_controller/JointTrajectoryController\n      command_interfaces: [effort]\n"
      "      gains: {j1: {p: 600.0, d: 30.0}}\n";
  const RosController found = chosen_controller(ros_controllers(text, "f.yaml"), "f.yaml");
  Gains gains = joint_trajectory_gains(found, "f.yaml", {"j1"});
  EXPECT_EQ(own(gains, "jtc_p")[0], 600.0);
  own(gains, "jtc_p")[0] = 700.0;
  const std::string changed = with_gains(text, found, "f.yaml", gains, {"j1"});
  EXPECT_THAT(changed, HasSubstr("p: 700.0, d: 30.0"));
  EXPECT_EQ(test::without_numbers(changed), test::without_numbers(text));
}

// A launch file or xacro puts a prefix in place of the words in brackets.
TEST(ControllerFile, JointsMayHaveAPrefixOfTheLaunchFile) {
  for (const std::string prefix : {"$(arg prefix)", "$(var prefix)", "${prefix}"}) {
    const std::string text = "c:\n  type: effort_controllers/JointTrajectoryController\n  joints: ['" +
                             prefix + "j1', '" + prefix + "j2']\n  gains:\n    " + prefix +
                             "j1: {p: 3000.0, i: 0.0, d: 2.0}\n    \"" + prefix +
                             "j2\": {p: 50.0, i: 0.0, d: 1.0}\n  velocity_ff:\n    " + prefix + "j2: 0.5\n";
    const RosController found = chosen_controller(ros_controllers(text, "f.yaml"), "f.yaml");
    Gains gains = joint_trajectory_gains(found, "f.yaml", {"j1", "j2"});
    EXPECT_EQ(own(gains, "jtc_p")[0], 3000.0) << prefix;
    EXPECT_EQ(own(gains, "jtc_d")[1], 1.0) << prefix;
    EXPECT_EQ(own(gains, "jtc_ff_velocity_scale")[1], 0.5) << prefix;
    own(gains, "jtc_p")[1] = 60.0;
    EXPECT_THAT(with_gains(text, found, "f.yaml", gains, {"j1", "j2"}),
                HasSubstr("{p: 60.0, i: 0.0, d: 1.0}"));
    EXPECT_THAT(refused(text, {"j1"}), refused_at({.value = "j2", .limit = "one of: j1"}));
  }
  EXPECT_THAT(
      refused("c:\n  gains:\n    $(arg left)j1: {p: 1.0}\n    $(arg right)j1: {p: 2.0}\n  joints: [j1]\n",
              {"j1"}),
      refused_at({.file = "f.yaml", .line = 4, .value = "$(arg right)j1"}));
}

TEST(ControllerFile, JumpsFromPointToPointWhereItsMethodOfInterpolationIsNone) {
  const auto jumps = [](const std::string& text) {
    const RosController controller = chosen_controller(ros_controllers(text, "f.yaml"), "f.yaml");
    joint_trajectory_gains(controller, "f.yaml", {"j1"});
    return jumps_between_points(controller);
  };
  for (const std::string commands : {"effort", "velocity"}) {
    EXPECT_TRUE(jumps(with_j1("p: 1.0", commands) + "    interpolation_method: none\n"));
    EXPECT_FALSE(jumps(with_j1("p: 1.0", commands) + "    interpolation_method: splines\n"));
    EXPECT_FALSE(jumps(with_j1("p: 1.0", commands)));
  }
  EXPECT_FALSE(
      jumps("c:\n  type: effort_controllers/JointTrajectoryController\n  interpolation_method: none\n"
            "  gains: {j1: {p: 1.0}}\n"))
      << "ROS 1 has no such parameter";
}

TEST(ControllerFile, WithVelocityCommandsIsAKindOfItsOwn) {
  const std::vector<std::string> j1 = {"j1"};
  const std::string ros1 =
      "c:\n  type: velocity_controllers/JointTrajectoryController\n  velocity_ff: {j1: 1.0}\n"
      "  gains: {j1: {p: 5.0, i: 0.5, d: 0.1, i_clamp: 1.0}}\n";
  for (const std::string& text :
       {with_j1("p: 5.0, i: 0.5, d: 0.1, i_clamp: 1.0, ff_velocity_scale: 1.0", "velocity"), ros1}) {
    const RosController controller = chosen_controller(ros_controllers(text, "f.yaml"), "f.yaml");
    Gains gains = joint_trajectory_gains(controller, "f.yaml", j1);
    EXPECT_EQ(gains.controller, "joint_trajectory_controller_velocity");
    EXPECT_EQ(own(gains, "jtc_velocity_p")[0], 5.0);
    EXPECT_EQ(own(gains, "jtc_velocity_i")[0], 0.5);
    EXPECT_EQ(own(gains, "jtc_velocity_d")[0], 0.1);
    EXPECT_EQ(own(gains, "jtc_velocity_i_clamp")[0], 1.0);
    EXPECT_EQ(own(gains, "jtc_velocity_ff_velocity_scale")[0], 1.0);
    own(gains, "jtc_velocity_p")[0] = 7.25;
    const std::string changed = with_gains(text, controller, "f.yaml", gains, j1);
    EXPECT_THAT(changed, HasSubstr("{p: 7.25, i: 0.5,"));
    EXPECT_EQ(test::without_numbers(changed), test::without_numbers(text));
    change_controller(gains, "joint_trajectory_controller", 1);
    EXPECT_THAT(test::refusal([&] { with_gains(text, controller, "f.yaml", gains, j1); }),
                HasSubstr("c is a joint_trajectory_controller_velocity"));
  }
}

TEST(ControllerFile, OneOfSeveralIsAskedForByName) {
  const std::string two =
      with_j1("p: 1.0") +
      "d:\n  ros__parameters:\n    joints: [j1]\n    command_interfaces: [effort]\n    gains: {j1: {p: 2.0}}\n";
  const auto all = ros_controllers(two, "f.yaml");
  EXPECT_THAT([&] { chosen_controller(all, "f.yaml"); },
              refused_at({.file = "f.yaml", .value = "2", .limit = "one of: c, d"}));

  EXPECT_EQ(own(joint_trajectory_gains(chosen_controller(all, "f.yaml", "d"), "f.yaml", {"j1"}), "jtc_p")[0],
            2.0);
  EXPECT_THAT([&] { chosen_controller(all, "f.yaml", "e"); },
              refused_at({.value = "e", .limit = "one of: c, d"}));
}

}  // namespace controller_file_test
}  // namespace armtune::internal
