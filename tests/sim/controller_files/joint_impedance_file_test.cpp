// Parameter files of joint impedance controllers: read with what each controller does, changed in numbers
// alone.

#include "sim/controller_files/joint_impedance_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/valid_gains.hpp"
#include "sim/controller_files/changed_gains.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/without_numbers.hpp"

namespace armtune::internal {
namespace joint_impedance_file_test {

using test::refused_at;
using testing::HasSubstr;

const std::vector<std::string> kJoints = {"j1", "j2", "j3"};

RosController only(const std::string& text) {
  return chosen_controller(ros_controllers(text, "f.yaml"), "f.yaml");
}

Gains read(const std::string& text) {
  return controller_gains(only(text), "f.yaml", kJoints);
}

/// The error with which a text is refused.
InputError refused(const std::string& text) {
  return test::input_error([&] { read(text); });
}

/// As in franka_ros.
std::string ros1(const std::string& more = "", const std::string& type = "JointImpedanceExampleController") {
  return "joint_impedance_example_controller:\n    type: franka_example_controllers/" + type +
         "\n    arm_id: $(arg arm_id)\n    joint_names:\n        - $(arg arm_id)_joint1\n        - "
         "$(arg arm_id)_joint2\n        - $(arg arm_id)_joint3\n    k_gains:\n        - 600.0\n        - 250.0  # "
         "soft\n        - 50.0\n    d_gains: [50.0, 20.0, 10.0]\n" +
         more;
}

/// As in franka_ros2: types and parameters in different nodes.
std::string ros2(const std::string& type) {
  return "controller_manager:\n  ros__parameters:\n    update_rate: 1000\n    impedance:\n      type: "
         "franka_example_controllers/" +
         type +
         "\n\nimpedance:\n  ros__parameters:\n    arm_id: panda\n    k_gains:\n      - 24.0\n      - 10.0\n      - "
         "2.0\n    d_gains:\n      - 2.0\n      - 1.0\n      - 0.5\n";
}

TEST(JointImpedanceFile, EachTypeIsReadWithWhatItsControllerDoes) {
  struct Case {
    std::string text;
    double velocity, coriolis, rate;
  };
  for (const Case& c : {Case{ros1(), 1.0, 1.0, 1000.0},
                        {ros1("    coriolis_factor: 0.5\n"), 1.0, 0.5, 1000.0},
                        {ros2("JointImpedanceExampleController"), 0.0, 0.0, 0.0},
                        {ros2("JointImpedanceWithIKExampleController"), 0.0, 1.0, 0.0}}) {
    const Gains gains = read(c.text);
    EXPECT_EQ(gains.controller, "joint_impedance");
    EXPECT_EQ(own(gains, "joint_impedance_velocity_factor")[0], c.velocity);
    EXPECT_EQ(own(gains, "joint_impedance_coriolis_factor")[0], c.coriolis);
    EXPECT_EQ(own(gains, "joint_impedance_torque_rate")[0], c.rate);
    EXPECT_EQ(own(gains, "joint_impedance_filter")[0], 0.01);
    EXPECT_NO_THROW(validate(gains, kJoints, "f.yaml"));
  }
  EXPECT_EQ(own(read(ros1()), "joint_impedance_k"), JointVector(Vec3(600.0, 250.0, 50.0)));
  EXPECT_EQ(own(read(ros1()), "joint_impedance_d"), JointVector(Vec3(50.0, 20.0, 10.0)));
}

TEST(JointImpedanceFile, WhatIsNotKnownIsRefusedAtItsLine) {
  EXPECT_THAT(refused(ros1("", "OwnController")),
              refused_at({.file = "f.yaml",
                          .line = 2,
                          .value = "franka_example_controllers/OwnController",
                          .limit = HasSubstr("JointImpedanceWithIKExampleController")}));
  EXPECT_THAT(refused("c:\n  k_gains: [1.0, 1.0, 1.0]\n  d_gains: [1.0, 1.0, 1.0]\n"),
              refused_at({.line = 2, .value = ""}));
  EXPECT_THAT(
      refused("c:\n  type: x/JointImpedanceExampleController\n  k_gains: [1.0, 1.0]\n  d_gains: [1.0, "
              "1.0, 1.0]\n"),
      refused_at({.line = 3, .value = "2", .limit = "3"}));
  EXPECT_THAT(
      refused("c:\n  type: x/JointImpedanceExampleController\n  k_gains: [1.0, a, 1.0]\n  d_gains: [1.0, "
              "1.0, 1.0]\n"),
      refused_at({.line = 3, .value = "a", .limit = HasSubstr("plain number")}));
  EXPECT_THAT(
      refused("c:\n  type: x/JointImpedanceExampleController\n  joint_names: [j2, j1, j3]\n  k_gains: "
              "[1.0, 1.0, 1.0]\n  d_gains: [1.0, 1.0, 1.0]\n"),
      refused_at({.line = 3, .value = "j2, j1, j3", .limit = "j1, j2, j3"}));
}

TEST(JointImpedanceFile, OnlyNumbersOfGainsChangeAndTheFileReadsBack) {
  for (const std::string& text :
       {ros1(), ros1("    coriolis_factor: 1.0\n"), ros2("JointImpedanceExampleController"),
        ros2("JointImpedanceWithIKExampleController")}) {
    const RosController controller = only(text);
    Gains gains = read(text);
    EXPECT_EQ(with_gains(text, controller, "f.yaml", gains, kJoints), text);
    own(gains, "joint_impedance_k") = Vec3(0.1, 1e22, 1.0 / 3.0);
    own(gains, "joint_impedance_d")[2] = 7.25;
    const std::string changed = with_gains(text, controller, "f.yaml", gains, kJoints);
    EXPECT_EQ(test::without_numbers(changed), test::without_numbers(text));
    const Gains back = read(changed);
    for (std::size_t k = 0; k < gains.own.size(); ++k) EXPECT_EQ(back.own[k], gains.own[k]);
  }
  Gains gains = read(ros1());
  own(gains, "joint_impedance_coriolis_factor")[0] = 0.0;
  EXPECT_THAT(test::refusal([&] { with_gains(ros1(), only(ros1()), "f.yaml", gains, kJoints); }),
              HasSubstr("joint_impedance_coriolis_factor must become 0.0"));
}

TEST(JointImpedanceFile, ATrajectoryControllerOfTheFileComesFirst) {
  const std::string trajectory =
      "arm:\n  ros__parameters:\n    joints: [j1, j2, j3]\n    command_interfaces: [effort]\n    gains: {j1: {p: "
      "1.0}, j2: {p: 1.0}, j3: {p: 1.0}}\n";
  const std::string text = ros2("JointImpedanceExampleController") + trajectory;
  EXPECT_EQ(read(text).controller, "joint_trajectory_controller");
  const auto all = ros_controllers(text, "f.yaml");
  EXPECT_EQ(controller_gains(chosen_controller(all, "f.yaml", "impedance"), "f.yaml", kJoints).controller,
            "joint_impedance");
  EXPECT_TRUE(may_hold_controllers(ros1()));
}

}  // namespace joint_impedance_file_test
}  // namespace armtune::internal
