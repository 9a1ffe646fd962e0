#pragma once
// Computes the references of the joints from those of the tool (equation 2 in NOTATION.md):
//   qr' = J+ xr',   qr'' = J+ (xr'' - J' qr').
//
// With more joints than task components, many joint motions fulfil the task. The reference is the one of
// these motions that is closest to a motion z, which moves the joints towards the middle of their position
// limits (Liegeois, Automatic supervisory control of the configuration and behavior of multibody mechanisms,
// 1977):
//   qr' = z + J^T L,   L = (J J^T)^-1 (xr' - J z),   z = -k (q - middle).
// qr'' is the derivative of qr' along the motion:
//   qr'' = y + J^T (J J^T)^-1 (xr'' - J' qr' - J y),   y = z' + J'^T L.
//
// For a task with fewer components (task_mask.hpp), E J replaces J, where the matrix E selects the
// components. If E turns with the tool, its derivative E' is not zero: it adds J^T (0, w x L_o) to y and
// subtracts (0, w x r_o) from xr''. Here w is the tool's angular velocity, r = xr' - J qr' is the part of xr'
// that is not in the task, and L_o and r_o are the last three components of L and r, those of orientation.

#include "core/control/cartesian_law.hpp"
#include "core/control/joint_centering.hpp"
#include "core/control/joint_space_law.hpp"
#include "core/control/measured_arm.hpp"

namespace armtune::internal {

/// Returns (0, w x L_angular), for a task whose matrix E turns with the tool at the angular velocity w. If L
/// are multipliers, L = E^T l, the result is E'^T l. If L is a motion, E times the result is -E' L.
template <typename T>
Vec6T<T> turning(const Vec3T<T>& w, const Vec6T<T>& L) {
  Vec6T<T> turned = Vec6T<T>::Zero();
  turned.template tail<3>() = w.cross(L.template tail<3>());
  return turned;
}

/// Computes the velocity qr' (n). rate: xr'. arm: the arm after measure() at q (n). Returns L, which
/// resolve_acceleration needs.
template <typename T>
Vec6T<T> resolve_velocity(const Vec6T<T>& rate, const MeasuredArmT<T>& arm,
                          const JointCenteringT<T>& centering, const JointVectorT<T>& q,
                          JointVectorT<T>& velocity) {
  if (arm.inverse.is_square()) {
    arm.inverse.apply(rate, velocity);
    return Vec6T<T>::Zero();
  }
  velocity = centering.velocity(q);
  Vec6T<T> L = arm.inverse.multipliers(rate - times(arm.J, velocity));
  JointVectorT<T> back;
  transposed_times(arm.J, L, back);
  velocity += back;
  return L;
}

/// Computes qr'' (n). x: xr' and xr''. arm: the arm after measure() and differentiate() with the joint
/// velocities qd (n). L: result of resolve_velocity. reference: must already contain qr'.
template <typename T>
void resolve_acceleration(const TaskReferenceT<T>& x, const MeasuredArmT<T>& arm,
                          const JointCenteringT<T>& centering, const JointVectorT<T>& qd, const Vec6T<T>& L,
                          JointReferenceT<T>& reference) {
  const TaskInverseT<T>& inverse = arm.inverse;
  Vec6T<T> wanted = x.acceleration - times(arm.J_dot, reference.velocity);
  if (inverse.is_square()) return inverse.apply(wanted, reference.acceleration);
  JointVectorT<T> back;
  reference.acceleration = centering.acceleration(qd);
  transposed_times(arm.J_dot, L, back);
  reference.acceleration += back;
  if (inverse.mask() == TaskMask::kPositionAndAxis) {
    const Vec3T<T> w = arm.twist.template tail<3>();
    transposed_times(arm.J, turning(w, L), back);
    reference.acceleration += back;
    const Vec6T<T> left = x.rate - times(arm.J, reference.velocity);
    wanted -= turning(w, left);
  }
  transposed_times(arm.J, inverse.multipliers(wanted - times(arm.J, reference.acceleration)), back);
  reference.acceleration += back;
}

/// Computes qr' and qr'' (n). arm: the arm after measure() and differentiate() at q, qd (n).
template <typename T>
void resolve(const TaskReferenceT<T>& x, const MeasuredArmT<T>& arm, const JointCenteringT<T>& centering,
             const JointVectorT<T>& q, const JointVectorT<T>& qd, JointReferenceT<T>& reference) {
  const Vec6T<T> L = resolve_velocity(x.rate, arm, centering, q, reference.velocity);
  resolve_acceleration(x, arm, centering, qd, L, reference);
}

}  // namespace armtune::internal
