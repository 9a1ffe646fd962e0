#pragma once
// An obstacle that the arm avoids: a ball in the base frame. The scalar type T is double for one arm, or a
// SIMD type for several arms at once (chain.hpp).

#include <string>

#include "core/trajectory/path.hpp"

namespace armtune::internal {

/// A ball, stored as four numbers. The center must be the first member, because sim/lanes reads the four
/// numbers in this order.
template <typename T>
struct ObstacleT {
  Vec3T<T> center = Vec3T<T>::Zero();  ///< [m]
  T radius = T(0);                     ///< radius of the ball [m]; 0: a point
};
using Obstacle = ObstacleT<double>;

/// A ball that moves along a path.
struct MovingObstacle {
  std::string name;
  Path path;            ///< path of the centre
  double radius = 0.0;  ///< radius of the ball [m]

  /// Returns the ball at t [s].
  Obstacle at(double t) const { return {path.at(t).position, radius}; }
};

}  // namespace armtune::internal
