#pragma once
// Spherical interpolation (slerp) between two orientations, Q(s) = exp(s phi) Q_start, with its angular
// velocity and acceleration. phi is the rotation vector from start to goal, and s runs from 0 to 1.

#include "core/trajectory/rotation_rate.hpp"

namespace armtune::internal {

struct OrientationPoint {
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Vec3 angular_velocity = Vec3::Zero();      ///< base frame [rad/s]
  Vec3 angular_acceleration = Vec3::Zero();  ///< base frame [rad/s^2]
};

/// Interpolates towards a fixed goal. phi: rotation vector from start to goal, base frame [rad]. s:
/// interpolation parameter with its derivatives. The axis is fixed, so velocity and acceleration are s' phi
/// and s'' phi.
inline OrientationPoint slerp(const Eigen::Quaterniond& start, const Vec3& phi,
                              const MotionPoint<double>& s) {
  return {rotation_exp(s.position * phi) * start, s.velocity * phi, s.acceleration * phi};
}

/// Interpolates towards a moving goal: Q(t) = exp(s(t) phi(t)) Q_start. phi: as above, with its derivatives.
inline OrientationPoint slerp(const Eigen::Quaterniond& start, const MotionPoint<Vec3>& phi,
                              const MotionPoint<double>& s) {
  const TurnRate rate = rotation_rate(
      {s.position * phi.position, s.velocity * phi.position + s.position * phi.velocity,
       s.acceleration * phi.position + 2.0 * s.velocity * phi.velocity + s.position * phi.acceleration});
  return {rotation_exp(s.position * phi.position) * start, rate.velocity, rate.acceleration};
}

/// Returns the rotation `inner` followed by `outer`, both about base axes: Q = Q_outer Q_inner. The result
/// includes the angular velocity and acceleration.
inline OrientationPoint composed(const OrientationPoint& outer, const OrientationPoint& inner) {
  const Vec3 carried = outer.orientation * inner.angular_velocity;
  return {outer.orientation * inner.orientation, outer.angular_velocity + carried,
          outer.angular_acceleration + outer.orientation * inner.angular_acceleration +
              outer.angular_velocity.cross(carried)};
}

}  // namespace armtune::internal
