#pragma once
// A joint_trajectory_controller as its parameter file has it, and which of its gains a study tunes.

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "core/robot/robot_model.hpp"
#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

struct ControllerInFile {
  std::string file;  ///< its name
  std::string text;  ///< and what stands in it
  RosController controller;
  std::vector<std::string> joints;  ///< of the arm, in its order
  Gains gains;
};

/// Reads the controller that `node` names, or the only one of the file where it is empty. Throws InputError
/// if there is no such controller for these joints, if all of its p, i and d are 0, or if the file could not
/// hold other numbers than it has.
ControllerInFile read_controller(const std::string& file, const std::string& node,
                                 const std::vector<std::string>& joints);

/// Which gains a study tunes, as lines of its `parameters`: every p, i and d that is not 0, and of effort
/// commands every d of 0 that the file has a number for and whose p is not 0, from none to five times what
/// the arm's inertia asks for at q (n). undamped: gets the joints of the latter.
std::string tuned_parameters(const ControllerInFile& from, const RobotModel& arm, const JointVector& q,
                             std::vector<std::string>& undamped);

}  // namespace armtune::internal
