#include "tuner/controller_study/controller_rate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/controller_files/controller_gains.hpp"
#include "tests/tuner/support/joint_trajectory_example.hpp"

namespace armtune::internal {
namespace controller_rate_test {

using test::changed_example;
using test::refused_at;

/// The rate that is read of a file.
ControllerRate rate_in(const std::string& text) {
  return controller_rate(chosen_controller(ros_controllers(text, "f.yaml"), "f.yaml"), "f.yaml")
      .value_or(ControllerRate{std::numeric_limits<double>::quiet_NaN(), "none"});
}

/// The rate that is read of the example's parameters with one text in place of another; NaN: none.
double rate_of(const std::string& from, const std::string& to) {
  return rate_in(changed_example(from, to)).hertz;
}

TEST(ControllerRate, IsTheControllersOwnThenThatOfItsManagerAndOfNoOtherNode) {
  EXPECT_EQ(rate_of("update_rate: 500", "update_rate: 400"), 400.0);
  const std::string effort = "command_interfaces: [effort]";
  EXPECT_EQ(rate_of(effort, effort + "\n    update_rate: 100"), 100.0);
  EXPECT_EQ(rate_of(effort, effort + "\n    update_rate: 0"), 500.0) << "0 stands for the manager's";
  // Another node with a rate of its own, before the manager and in its place.
  const std::string other = "state_broadcaster:\n  ros__parameters:\n    update_rate: 50\n";
  EXPECT_EQ(rate_of("controller_manager:", other + "controller_manager:"), 500.0);
  EXPECT_TRUE(std::isnan(rate_of("controller_manager:", "state_broadcaster:")));
  EXPECT_EQ(rate_of("controller_manager:", "/left/controller_manager:"), 500.0);
  EXPECT_EQ(rate_of("controller_manager:", "\"/**\":"), 500.0);
  for (const char* wrong : {"5", "0", "-1", "fast", "1e9"})
    EXPECT_THAT([&] { rate_of("update_rate: 500", std::string("update_rate: ") + wrong); },
                refused_at({.file = "f.yaml",
                            .line = 3,
                            .key = "controller_manager/update_rate",
                            .value = wrong,
                            .limit = "10 to 10000 Hz"}));
}

// As in the driver of Universal Robots for ROS 1, and in the template of ros_control_boilerplate.
TEST(ControllerRate, OfRos1IsThatOfTheControlLoop) {
  const std::string arm =
      "arm:\n  type: effort_controllers/JointTrajectoryController\n  gains: {j1: {p: 1.0}}\n";
  const auto found = [&arm](const std::string& more) { return rate_in(arm + more); };
  EXPECT_EQ(found("hardware_control_loop:\n   loop_hz: &loop_hz 125\n").hertz, 125.0);
  EXPECT_EQ(found("hardware_control_loop: {loop_hz: 125}\n").key, "hardware_control_loop/loop_hz");
  EXPECT_EQ(found("left: {generic_hw_control_loop: {loop_hz: 300}}\n").hertz, 300.0);
  EXPECT_EQ(found("hardware_interface: {loop_hz: 300, joints: [j1]}\n").hertz, 300.0);
  EXPECT_TRUE(std::isnan(found("joint_state_controller: {publish_rate: 50, loop_hz: 50}\n").hertz));
  EXPECT_EQ(found("controller_manager: {update_rate: 250}\nhardware_control_loop: {loop_hz: 125}\n").hertz,
            250.0);
  EXPECT_THAT([&] { found("hardware_control_loop: {loop_hz: 2}\n"); },
              refused_at({.line = 4, .key = "hardware_control_loop/loop_hz", .value = "2"}));
}

}  // namespace controller_rate_test
}  // namespace armtune::internal
