#pragma once
// A path as a finite sum of harmonics, which covers the circle, the targets and the obstacles:
//   p(t) = c + sum_k A_k cos(k phi) + B_k sin(k phi),   phi = w t + phase.

#include <vector>

#include "core/common/types.hpp"
#include "core/trajectory/motion_point.hpp"

namespace armtune {

struct HarmonicTerm {
  int order = 1;               ///< k >= 0; an order may stand more than once
  Vec3 cosine = Vec3::Zero();  ///< A_k [m]
  Vec3 sine = Vec3::Zero();    ///< B_k [m]
};

struct HarmonicPath {
  Vec3 center = Vec3::Zero();  ///< [m]
  double frequency = 0.0;      ///< w [rad/s]; zero: a point at rest
  double phase = 0.0;          ///< [rad]
  std::vector<HarmonicTerm> terms;

  /// Position [m], velocity and acceleration at t [s]; exact derivatives. Allocates nothing.
  MotionPoint<Vec3> at(double t) const;
};

}  // namespace armtune
