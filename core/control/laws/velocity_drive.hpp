#pragma once
// A model of joint drives that take velocity commands, as in industrial arms with a velocity interface. Each
// drive is a PI controller on its joint's velocity error, within the joint's limits. Manufacturers do not
// publish the gains of real drives. If the robot's file gives no gains, the errors of the velocity loops are
// assumed to decay at the rate kDriveRate.

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

/// Returns the gains that the robot's file gives. Missing ones are computed from kDriveRate and
/// kDriveIntegralRate.
DriveGains drive_gains(const RobotModel& model);

/// Returns the share of each joint's velocity error (n) that its drive removes in one of its periods [s] at q
/// (n), with the other joints free. If the share is above 1, the error changes its sign in every period. Near
/// 2 the arm oscillates for ever, and above 2 the oscillation grows.
JointVector drive_step(const RobotModel& model, const JointVector& q, double period);

class VelocityDrives {
 public:
  explicit VelocityDrives(const RobotModel& model);

  /// Sets the integrals to the given torques (n) [N m, N], which hold the arm at the start. Real drives do
  /// the same when their brakes are released.
  void hold(const JointVector& torque);

  /// Computes the torques (n) for the commanded velocities (n), which are first clamped to the joints'
  /// velocity limits. qd (n): velocities of the joints [rad/s, m/s]. Advances the integrals by dt [s], within
  /// the effort limits. Allocates nothing.
  void torque(const JointVector& commanded, const JointVector& qd, double dt, JointVector& tau);

 private:
  DriveGains gains_;
  JointVector velocity_, effort_;  ///< limits
  JointVector integral_;           ///< torque of the integral
};

}  // namespace armtune::internal
