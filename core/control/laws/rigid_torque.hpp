#pragma once
// Computes the gravity torque, and the Coriolis and centrifugal torque, from the controller's model of the
// arm, without friction. Franka's robots add the gravity torque themselves, so that impedance controllers for
// them add only the Coriolis and centrifugal torque. The code is a template for one arm or several at once
// (arm_law.hpp).

#include "core/control/laws/arm_law.hpp"
#include "core/robot/theta.hpp"

namespace armtune::internal {

template <typename T>
class RigidTorqueT : LaneAccessT<T> {
 public:
  /// n: number of joints.
  explicit RigidTorqueT(int n)
      : theta_(ParameterVectorT<T>::Zero((kLinkParameters + kJointParameters) * n)),
        rest_(JointVectorT<T>::Zero(n)) {}

  /// theta (13 n): parameters of the controller's model of the arm. Its friction is not used.
  void start(int lane, const double* theta) {
    const auto n = static_cast<int>(rest_.size());
    this->put_all(lane, theta, theta_);
    for (int i = 0; i < n; ++i) {
      const int viscous = joint_parameter_index(n, i) + 1;
      this->put(lane, 0.0, theta_[viscous]);
      this->put(lane, 0.0, theta_[viscous + 1]);
    }
  }

  /// Computes g(q) (n) [N m, N].
  void at_rest(const LawPeriodT<T>& at, JointVectorT<T>& tau) { moving(at, rest_, tau); }

  /// Computes C(q, v) v + g(q) (n) [N m, N] at the joint velocities v (n).
  void moving(const LawPeriodT<T>& at, const JointVectorT<T>& v, JointVectorT<T>& tau) {
    slotine_li_forward(at.chain, at.arm.poses, v, v, rest_, motion_);
    slotine_li_torque(at.chain, at.arm.poses, motion_, theta_, tau);
  }

 private:
  ParameterVectorT<T> theta_;
  JointVectorT<T> rest_;  ///< zeros
  SlotineLiT<T> motion_;
};

}  // namespace armtune::internal
