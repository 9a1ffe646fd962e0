#pragma once
// Parameter files of joint_trajectory_controllers, as texts.

#include <fmt/format.h>

#include <string>
#include <vector>

#include "sim/controller_files/joint_trajectory_file.hpp"
#include "sim/controller_files/parameter_file.hpp"
#include "tests/core/support/refused_at.hpp"

namespace armtune::internal::test {

/// The joints of the arm to which a text belongs.
inline const std::vector<std::string> kJoints = {"j1", "j2", "j3"};

/// The error with which a text is refused.
inline InputError refused(const std::string& text, const std::vector<std::string>& joints = kJoints) {
  return input_error([&] {
    joint_trajectory_gains(chosen_controller(ros_controllers(text, "f.yaml"), "f.yaml"), "f.yaml", joints);
  });
}

/// A ROS 2 file with these gains of j1.
inline std::string with_j1(const std::string& gains, const std::string& commands = "effort") {
  return fmt::format(
      "c:\n  ros__parameters:\n    joints: [j1]\n    command_interfaces: [{}]\n    gains:\n      j1: {{{}}}\n",
      commands, gains);
}

}  // namespace armtune::internal::test
