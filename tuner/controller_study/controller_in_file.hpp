#pragma once
// Reads a joint_trajectory_controller from its ROS parameter file, and selects which of its gains are tuned.

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "core/robot/robot_model.hpp"
#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

struct ControllerInFile {
  std::string file;  ///< name of the file
  std::string text;  ///< contents of the file
  RosController controller;
  std::vector<std::string> joints;  ///< names of the arm's joints, in its order
  Gains gains;
};

/// Reads the controller called `node`, or the only one of the file if `node` is empty. Throws InputError if
/// there is no such controller for these joints, if all of its p, i and d are 0, or if the file is written in
/// a way that does not allow its gains to be replaced.
ControllerInFile read_controller(const std::string& file, const std::string& node,
                                 const std::vector<std::string>& joints);

/// Returns the gains that a study tunes, as lines of its `parameters`: all p, i and d that are not 0. If the
/// controller commands efforts, a joint's d of 0 is tuned too, provided that the file has a place for it and
/// that the joint's p is not 0. The range of such a d is 0 to five times the damping that fits the arm's
/// inertia at q (n) [rad, m]. undamped: receives the names of the joints with such a d.
std::string tuned_parameters(const ControllerInFile& from, const RobotModel& arm, const JointVector& q,
                             std::vector<std::string>& undamped);

}  // namespace armtune::internal
