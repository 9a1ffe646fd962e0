#pragma once
// What the arm keeps away from: a ball in the base frame. Scalar type T, as in chain.hpp.

#include <string>

#include "core/trajectory/path.hpp"

namespace armtune::internal {

/// Four numbers, center first (sim/lanes counts on it).
template <typename T>
struct ObstacleT {
  Vec3T<T> center = Vec3T<T>::Zero();  ///< [m]
  T radius = T(0);                     ///< of its body [m]; 0: a point
};
using Obstacle = ObstacleT<double>;

/// A ball on its way.
struct MovingObstacle {
  std::string name;
  Path path;            ///< of its centre
  double radius = 0.0;  ///< of its body [m]

  /// At t [s].
  Obstacle at(double t) const { return {path.at(t).position, radius}; }
};

}  // namespace armtune::internal
