#pragma once
// The quantities that control laws compute once per control period from the measured joint positions and
// velocities: poses, Jacobian, and the Jacobian's inverse.

#include "core/control/task_inverse.hpp"
#include "core/robot/kinematics.hpp"

namespace armtune::internal {

template <typename T>
struct MeasuredArmT {
  PosesT<T> poses;
  JacobianT<T> J;
  JacobianT<T> J_dot;
  Vec6T<T> twist;  ///< (v_0T, w_0T)
  TaskInverseT<T> inverse;

  MeasuredArmT() = default;
  MeasuredArmT(const MeasuredArmT&) = delete;  // the inverse refers to this J
  MeasuredArmT& operator=(const MeasuredArmT&) = delete;

  /// Computes everything except J_dot at q, q' (n).
  void measure(const ChainT<T>& chain, const JointVectorT<T>& q, const JointVectorT<T>& qd,
               const InverseDampingT<T>& damping, TaskMask mask) {
    forward_kinematics(chain, q, poses);
    tool_jacobian(chain, poses, J);
    twist = times(J, qd);
    inverse.compute(J, damping, mask, poses.R_0T);
  }
  /// Computes J_dot. measure() must have been called with the same q, q'.
  void differentiate(const ChainT<T>& chain, const JointVectorT<T>& qd) {
    tool_jacobian_derivative(chain, poses, twist, qd, J_dot);
  }
};
using MeasuredArm = MeasuredArmT<double>;

}  // namespace armtune::internal
