#pragma once
// Computes the velocity and acceleration references of the joints for a controller that tracks a joint
// motion, with the desired positions qd:
//   qr' = qd' - Kp (q - qd),   qr'' = qd'' - Kp (q' - qd').
// The motion is a quintic from the start pose to the goal (state leaveSingularity) or a planned trajectory
// (state followPlan).

#include "core/common/types.hpp"
#include "core/trajectory/quintic.hpp"

namespace armtune::internal {

template <typename T>
struct JointReferenceT {
  JointVectorT<T> velocity;      ///< qr' [rad/s]
  JointVectorT<T> acceleration;  ///< qr'' [rad/s^2]
};
using JointReference = JointReferenceT<double>;

/// Returns the desired joint positions, velocities and accelerations at t on the rest-to-rest quintic between
/// two joint positions (n each).
inline MotionPoint<JointVector> joint_trajectory(const JointVector& start, const JointVector& goal,
                                                 double duration, double t) {
  const MotionPoint<double> s = rest_to_rest(0.0, 1.0, duration).at(t);
  return {start + s.position * (goal - start), s.velocity * (goal - start), s.acceleration * (goal - start)};
}

/// Computes the references. q, qd: measured positions and velocities (n each).
inline void joint_space_references(const MotionPoint<JointVector>& desired, const JointVector& Kp,
                                   const JointVector& q, const JointVector& qd, JointReference& reference) {
  reference.velocity = desired.velocity - Kp.cwiseProduct(q - desired.position);
  reference.acceleration = desired.acceleration - Kp.cwiseProduct(qd - desired.velocity);
}

}  // namespace armtune::internal
