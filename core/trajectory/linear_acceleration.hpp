#pragma once
// Motion whose acceleration changes linearly in time: constant jerk, so a cubic in position.

#include "core/trajectory/motion_point.hpp"

namespace armtune::internal {

/// Motion s [s] after `start`, when the acceleration is `end_acceleration` h > 0 [s] after it. V: double or
/// an Eigen vector.
template <typename V>
MotionPoint<V> linear_acceleration(const MotionPoint<V>& start, const V& end_acceleration, double h,
                                   double s) {
  const V jerk = (end_acceleration - start.acceleration) / h;
  return {start.position + s * (start.velocity + s / 2.0 * (start.acceleration + s / 3.0 * jerk)),
          start.velocity + s * (start.acceleration + s / 2.0 * jerk), start.acceleration + s * jerk};
}

}  // namespace armtune::internal
