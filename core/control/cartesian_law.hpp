#pragma once
// Cartesian references (equations 1 and 2):
//   xr'  = xd' - Kp dx - Ki int(dx) dt,   xr'' = xd'' - Kp dx' - Ki dx,
//   qr'  = J+ xr',                        qr'' = J+ (xr'' - J' qr').

#include "core/control/joint_space_law.hpp"
#include "core/control/task_inverse.hpp"

namespace armtune {

/// Six-vectors (linear, angular) in the base frame.
struct CartesianErrors {
  Vec6 pose = Vec6::Zero();           ///< dx: position [m], then the rotation vector -log(Qd Q^-1) [rad]
  Vec6 rate = Vec6::Zero();           ///< dx' = (v - vd, w - wd)
  Vec6 integral = Vec6::Zero();       ///< int(dx) dt
  Vec6 desired_rate = Vec6::Zero();   ///< xd' = (vd, wd)
  Vec6 desired_accel = Vec6::Zero();  ///< xd''
};

/// xr' and xr''.
template <typename T>
struct TaskReferenceT {
  Vec6T<T> rate = Vec6T<T>::Zero();
  Vec6T<T> acceleration = Vec6T<T>::Zero();
};
using TaskReference = TaskReferenceT<double>;

inline TaskReference task_reference(const CartesianErrors& x, const Vec6& Kp, const Vec6& Ki) {
  return {x.desired_rate - Kp.cwiseProduct(x.pose) - Ki.cwiseProduct(x.integral),
          x.desired_accel - Kp.cwiseProduct(x.rate) - Ki.cwiseProduct(x.pose)};
}

/// qr' and qr''.
template <typename T>
void resolve(const TaskReferenceT<T>& x, const TaskInverseT<T>& inverse, const JacobianT<T>& J_dot,
             JointReferenceT<T>& reference) {
  inverse.apply(x.rate, reference.velocity);
  inverse.apply(Vec6T<T>(x.acceleration - times(J_dot, reference.velocity)), reference.acceleration);
}

}  // namespace armtune
