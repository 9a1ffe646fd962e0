#pragma once
// A motion whose acceleration changes linearly in time. Its jerk is constant, and its position is a cubic
// polynomial. Planned joint motions have this form between two knots (joint_spline.hpp).

#include "core/trajectory/motion_point.hpp"

namespace armtune::internal {

/// Returns the motion at the time s [s] after `start`. The acceleration reaches `end_acceleration` at the
/// time h > 0 [s] after `start`. V: double or an Eigen vector.
template <typename V>
MotionPoint<V> linear_acceleration(const MotionPoint<V>& start, const V& end_acceleration, double h,
                                   double s) {
  const V jerk = (end_acceleration - start.acceleration) / h;
  return {start.position + s * (start.velocity + s / 2.0 * (start.acceleration + s / 3.0 * jerk)),
          start.velocity + s * (start.acceleration + s / 2.0 * jerk), start.acceleration + s * jerk};
}

}  // namespace armtune::internal
