#pragma once
// Reads the controller of a study from its parameter file, or computes start gains for a controller that has
// no such file.

#include <optional>
#include <string>
#include <vector>

#include "core/control/gain_fields.hpp"
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

/// Reads a controller from a ROS parameter file: the controller called `node`, or the only one in the file if
/// `node` is empty. The file can also be a map of gains, which describes one controller (gain_map.hpp).
/// distro: see set_distro (parameter_file.hpp). Throws InputError if the distribution does not fit the file,
/// if there is no such controller for these joints, if all of its gains that can be tuned are 0, or if the
/// file is written in a way that does not allow its gains to be replaced.
ControllerInFile read_controller(const std::string& file, const std::string& node,
                                 const std::vector<std::string>& joints,
                                 std::optional<RosDistro> distro = {});

/// Returns armtune's controller of this kind with start gains for an arm at q (n) [rad, m]. Throws InputError
/// if it is not one of motion_controllers() (controller_gains.hpp).
ControllerInFile new_controller(const std::string& kind, const RobotModel& arm, const JointVector& q);

/// Returns the controller's own gains that a study tunes unless it names others.
std::vector<const GainField*> searched_fields(const ControllerInFile& from);

/// Returns the values of one of the controller's own gains.
JointVector& values_of(Gains& gains, const GainField& field);

/// True if the file has a number for value k of the gain. Only a map of gains can leave this number out.
bool is_in_file(const ControllerInFile& from, const GainField& field, Eigen::Index k);

/// Returns the name by which a study refers to one number of a gain, such as "jtc_p/elbow". part: the joint
/// or axis of the number; empty if the gain has only one number.
std::string entry_name(const GainField& field, const std::string& part);

/// Returns the name of the controller's stiffness.
const char* stiffness_of_controller(const ControllerInFile& from);

/// True if the controller has a stiffness that could be tuned.
bool has_stiffness(const ControllerInFile& from);
/// Returns the largest stiffness of each joint (n) from numbers that the user gives: one for each joint, or
/// one for all. For the axes of a task, returns six numbers; the user gives two or six. Lowers the start
/// values of a controller that has no file. Throws InputError if the controller has no stiffness, if the
/// count is wrong, or if a start value in the file is larger.
std::vector<double> bounded_stiffness(const std::vector<double>& given, ControllerInFile& from);

}  // namespace armtune::internal
