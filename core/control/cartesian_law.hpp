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

inline void cartesian_references(const CartesianErrors& x, const Vec6& Kp, const Vec6& Ki,
                                 const TaskInverse& inverse, const Jacobian& J_dot,
                                 JointReference& reference) {
  const Vec6 xr_dot = x.desired_rate - Kp.cwiseProduct(x.pose) - Ki.cwiseProduct(x.integral);
  const Vec6 xr_ddot = x.desired_accel - Kp.cwiseProduct(x.rate) - Ki.cwiseProduct(x.pose);
  inverse.apply(xr_dot, reference.velocity);
  const Vec6 rest = xr_ddot - J_dot * reference.velocity;
  inverse.apply(rest, reference.acceleration);
}

}  // namespace armtune
