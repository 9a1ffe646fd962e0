#pragma once
// Joint drives that are commanded velocities, as those of industrial arms under a velocity interface: a PI on
// each joint's velocity error, within the joint's limits. How real drives are tuned, their makers do not say:
// where the robot's file gives no figures, their velocity loops are taken to be as fast as kDriveRate.

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// [1/s], of the velocity loop of each joint with the others free, in the middle of the joints' ranges.
inline constexpr double kDriveRate = 60.0;
/// [1/s], of the integral beside the gain: a quarter of that rate.
inline constexpr double kDriveIntegralRate = 15.0;

/// What a drive is made of, (n) each.
struct DriveGains {
  JointVector gain;      ///< torque per velocity error [N m s/rad, N s/m]
  JointVector integral;  ///< torque per integrated velocity error [N m/rad, N/m]
};

/// Returns those of the robot's file, and kDriveRate's for what it leaves open.
DriveGains drive_gains(const RobotModel& model);

class VelocityDrives {
 public:
  explicit VelocityDrives(const RobotModel& model);

  /// Begins with integrals that give the torques (n) [N m, N] which hold the arm, as drives do when their
  /// brakes are released.
  void hold(const JointVector& torque);

  /// Gives the torques (n) for the commanded velocities (n), cut off at the joints' velocity limits, where
  /// the joints move at qd (n) [rad/s, m/s]. Moves the integrals on by dt [s], within the effort limits.
  /// Allocates nothing.
  void torque(const JointVector& commanded, const JointVector& qd, double dt, JointVector& tau);

 private:
  DriveGains gains_;
  JointVector velocity_, effort_;  ///< limits
  JointVector integral_;           ///< its torque
};

}  // namespace armtune::internal
