#pragma once
// The key `drives` of a robot YAML. It describes the drives of a robot that is commanded by velocities or
// positions (core/control/laws/joint_drives.hpp).

#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal {

/// Reads the map `drives` into the model. Each value is one number for all joints, or one for each joint as a
/// list or a map; `rate` is one number. Throws InputError for an unknown key, a number out of range, and a
/// gain that the model has already from `drive_velocity_gain` or `drive_velocity_integral`.
void read_drives(const yaml::Node& node, const std::vector<std::string>& joints, RobotModel& model);

/// A value of the drives that a robot's file gives.
struct DriveValue {
  std::string key;
  std::string unit;
  JointVector values;  ///< n, or one for the rate
};

/// Returns the values of the drives that the model has, in the order of the documentation.
std::vector<DriveValue> drive_values(const RobotModel& model);

/// Returns the key `drives` of a robot YAML with the values of the model. Returns an empty text if the model
/// has none.
std::string drives_yaml(const RobotModel& model);

}  // namespace armtune::internal
