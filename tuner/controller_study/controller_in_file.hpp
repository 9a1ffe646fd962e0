#pragma once
// Reads the controller of a study from its parameter file, or computes start gains for a controller that has
// no such file. Selects which of its gains are tuned.

#include <optional>
#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "core/robot/robot_model.hpp"
#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

struct ControllerInFile {
  std::string file;  ///< name of the file; empty if there is none
  std::string text;  ///< contents of the file
  RosController controller;
  std::vector<std::string> joints;  ///< names of the arm's joints, in the arm's order
  Gains gains;
  bool turns = true;  ///< false: no motion gives an orientation, so that gains of rotations have no effect
};

/// True if the controller tracks the tool, not the joints.
bool is_of_tool(const ControllerInFile& from);

/// Reads the controller called `node`, or the only one of the file if `node` is empty, or the controller that
/// a map of gains describes (gain_map.hpp). distro: see set_distro (parameter_file.hpp). Throws InputError if
/// the distribution does not fit the file, if there is no such controller for these joints, if all of its
/// gains that can be tuned are 0, or if the file is written in a way that does not allow its gains to be
/// replaced.
ControllerInFile read_controller(const std::string& file, const std::string& node,
                                 const std::vector<std::string>& joints,
                                 std::optional<RosDistro> distro = {});

/// Returns armtune's controller of this kind with start gains for an arm at q (n) [rad, m]. Throws InputError
/// if it is not one of motion_controllers() (controller_gains.hpp).
ControllerInFile new_controller(const std::string& kind, const RobotModel& arm, const JointVector& q);

/// Returns the gains that a study tunes, as lines of the study's `parameters`: all that are tuned by default,
/// are in the file if there is one, and are not 0. Gains that a robot accepts within fixed bounds get these
/// bounds. For a joint_trajectory_controller that commands efforts, a joint's d of 0 is tuned too, provided
/// that the file has a place for this d and that the joint's p is not 0. The range of such a d is 0 to five
/// times the damping that fits the arm's inertia at q (n) [rad, m]. undamped: receives the names of the
/// joints with such a d.
/// most_stiffness: largest stiffness of each joint (n) [N m/rad, N/m] or axis of the task (6) [N/m, N m];
/// empty: the stiffness is not tuned.
std::string tuned_parameters(const ControllerInFile& from, const RobotModel& arm, const JointVector& q,
                             const std::vector<double>& most_stiffness, std::vector<std::string>& undamped);

/// True if the controller has a stiffness that could be tuned.
bool has_stiffness(const ControllerInFile& from);
/// Returns the largest stiffness of each joint (n) from numbers that the user gives: one for each joint, or
/// one for all. For a task, returns six from two or six numbers. Lowers the start values of a controller that
/// has no file. Throws InputError if the controller has no stiffness, if the count is wrong, or if a start
/// value in the file is larger.
std::vector<double> bounded_stiffness(const std::vector<double>& given, ControllerInFile& from);

}  // namespace armtune::internal
