#pragma once
// Velocity drives that hold the arm's weight from the first control period on.

#include "core/control/laws/velocity_drive.hpp"

namespace armtune::internal {

/// The drives of an arm under a controller that commands joint velocities. At the start their integrals are
/// set to the torque that holds the arm. If the robot compensates gravity (RobotModel::compensates_gravity),
/// the integrals start at zero instead, and the gravity torque of each period is added to the drives' torque.
class HeldDrives {
 public:
  /// period: control period [s].
  HeldDrives(const RobotModel& model, double period)
      : drives_(model), period_(period), robot_holds_(model.compensates_gravity) {}

  /// True if the next call of torque() uses the weight.
  bool need_weight() const { return robot_holds_ || !begun_; }

  /// Computes the torques tau (n) [N m, N] for the commanded velocities (n). qd (n): velocities of the joints
  /// [rad/s, m/s]. weight (n): torque that holds the arm, where need_weight() is true. Is called once per
  /// period. Allocates nothing.
  void torque(const JointVector& velocity, const JointVector& qd, const JointVector& weight,
              JointVector& tau) {
    if (!robot_holds_ && !begun_) drives_.hold(weight);
    begun_ = true;
    drives_.torque(velocity, qd, period_, tau);
    if (robot_holds_) tau += weight;
  }

 private:
  VelocityDrives drives_;
  double period_;
  bool robot_holds_;
  bool begun_ = false;  ///< there was a period before
};

}  // namespace armtune::internal
