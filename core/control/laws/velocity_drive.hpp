#pragma once
// A model of joint drives with velocity commands, such as those of industrial arms under a velocity
// interface. Each drive is a PI controller on its joint's velocity error, within the joint's limits. Makers
// do not publish how real drives are tuned. If the robot's file gives no values, the velocity loops are
// assumed to be as fast as kDriveRate.

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Rate at which each joint's velocity error decays [1/s], with the other joints free, in the middle of the
/// joints' ranges.
inline constexpr double kDriveRate = 60.0;
/// Rate of the integral [1/s], relative to the gain: a quarter of kDriveRate.
inline constexpr double kDriveIntegralRate = 15.0;

/// The gains of the drives, (n) each.
struct DriveGains {
  JointVector gain;      ///< torque per velocity error [N m s/rad, N s/m]
  JointVector integral;  ///< torque per integrated velocity error [N m/rad, N/m]
};

/// Returns the gains of the robot's file; those that it lacks follow from kDriveRate.
DriveGains drive_gains(const RobotModel& model);

class VelocityDrives {
 public:
  explicit VelocityDrives(const RobotModel& model);

  /// Starts with integrals that give the torques (n) [N m, N] which hold the arm, as drives do when their
  /// brakes are released.
  void hold(const JointVector& torque);

  /// Computes the torques (n) for the commanded velocities (n), clamped to the joints' velocity limits, while
  /// the joints move at qd (n) [rad/s, m/s]. Advances the integrals by dt [s], within the effort limits.
  /// Allocates nothing.
  void torque(const JointVector& commanded, const JointVector& qd, double dt, JointVector& tau);

 private:
  DriveGains gains_;
  JointVector velocity_, effort_;  ///< limits
  JointVector integral_;           ///< torque of the integral
};

}  // namespace armtune::internal
