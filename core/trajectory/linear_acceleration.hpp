#pragma once
// A motion whose acceleration changes linearly in time: its jerk is constant, its position a cubic. Planned
// joint motions move in this way between two knots (joint_spline.hpp).

#include "core/trajectory/motion_point.hpp"

namespace armtune::internal {

/// Returns the motion s [s] after `start`, if the acceleration reaches `end_acceleration` h > 0 [s] after it.
/// V: double or an Eigen vector.
template <typename V>
MotionPoint<V> linear_acceleration(const MotionPoint<V>& start, const V& end_acceleration, double h,
                                   double s) {
  const V jerk = (end_acceleration - start.acceleration) / h;
  return {start.position + s * (start.velocity + s / 2.0 * (start.acceleration + s / 3.0 * jerk)),
          start.velocity + s * (start.acceleration + s / 2.0 * jerk), start.acceleration + s * jerk};
}

}  // namespace armtune::internal
