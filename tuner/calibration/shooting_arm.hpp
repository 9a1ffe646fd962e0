#pragma once
// An arm as calibration simulates it: a robot model, and what a robot file cannot contain: delay,
// payload, tilt of the base, and offsets of the encoders.

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

struct ShootingArm {
  RobotModel model;           ///< without shapes; if it has drives, all their gains are given
  double delay = 0.0;         ///< from a command to its effect [s]
  JointVector torque_factor;  ///< true torque per commanded torque (n)
  JointVector offset;         ///< true minus logged position (n) [rad, m]
};

/// Returns the arm of a robot file, without delay and offsets. Gains of drives that the file lacks get the
/// defaults of velocity_drive.hpp and joint_drives.hpp.
ShootingArm shooting_arm(const RobotModel& model);

}  // namespace armtune::internal
