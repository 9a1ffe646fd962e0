#pragma once
// Computes the velocity and acceleration references of the tool in Cartesian control (equation 1 in
// NOTATION.md). They are the desired motion xd plus feedback of the pose error dx:
//   xr'  = xd' - Kp dx - Ki int(dx) dt,   xr'' = xd'' - Kp dx' - Ki dx.

#include "core/common/types.hpp"

namespace armtune::internal {

/// The errors of the Cartesian law. Six-vectors are (linear, angular) in the base frame.
struct CartesianErrors {
  Vec6 pose = Vec6::Zero();           ///< dx: position [m], then the rotation vector -log(Qd Q^-1) [rad]
  Vec6 rate = Vec6::Zero();           ///< dx' = (v - vd, w - wd)
  Vec6 integral = Vec6::Zero();       ///< int(dx) dt
  Vec6 desired_rate = Vec6::Zero();   ///< xd' = (vd, wd)
  Vec6 desired_accel = Vec6::Zero();  ///< xd''
};

/// The references xr' and xr''.
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

/// Removes the feedback about the axis z (unit vector, base frame) from the reference, so that only the
/// desired motion about z remains. Use it for a tool that points at a target and may roll freely about its z
/// axis. Whenever this axis turns, the integral gets a component about z, and thereby commands a roll rate.
/// The roll is not part of the error, so no feedback would end this roll rate.
inline void without_roll_feedback(const CartesianErrors& x, const Vec3& z, TaskReference& reference) {
  reference.rate.tail<3>() -= z * z.dot(reference.rate.tail<3>() - x.desired_rate.tail<3>());
  reference.acceleration.tail<3>() -= z * z.dot(reference.acceleration.tail<3>() - x.desired_accel.tail<3>());
}

}  // namespace armtune::internal
