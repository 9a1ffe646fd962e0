#pragma once
// Computes the gravity torque, and the Coriolis and centrifugal torque, from the controller's model of the
// arm, without friction. Franka's robots add the gravity torque themselves, so that impedance controllers for
// them add only the Coriolis and centrifugal torque.

#include "core/control/measured_arm.hpp"
#include "core/robot/slotine_li.hpp"
#include "core/robot/theta.hpp"

namespace armtune::internal {

class RigidTorque {
 public:
  /// chain outlives this object. theta (13 n) is copied; its friction is not used.
  RigidTorque(const Chain& chain, const ParameterVector& theta)
      : chain_(chain), theta_(theta), rest_(JointVector::Zero(chain.n)) {
    for (int i = 0; i < chain.n; ++i) theta_.segment<2>(joint_parameter_index(chain.n, i) + 1).setZero();
  }

  /// Computes g(q) (n) [N m, N].
  void at_rest(const MeasuredArm& arm, JointVector& tau) { moving(arm, rest_, tau); }

  /// Computes C(q, v) v + g(q) (n) [N m, N] at the joint velocities v (n).
  void moving(const MeasuredArm& arm, const JointVector& v, JointVector& tau) {
    slotine_li_forward(chain_, arm.poses, v, v, rest_, motion_);
    slotine_li_torque(chain_, arm.poses, motion_, theta_, tau);
  }

 private:
  const Chain& chain_;
  ParameterVector theta_;
  JointVector rest_;  ///< zeros
  SlotineLi motion_;
};

}  // namespace armtune::internal
