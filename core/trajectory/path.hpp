#pragma once
// A path in time, of the tool, a target or an obstacle: a finite sum of harmonics about a centre, which
// covers circles and what is like them,
//   p(t) = c + sum_k A_k cos(k phi) + B_k sin(k phi),   phi = w t + phase,
// or a motion through knots, p(t) = c + spline(t).

#include <memory>
#include <vector>

#include "core/common/types.hpp"
#include "core/trajectory/motion_point.hpp"
#include "core/trajectory/position_spline.hpp"

namespace armtune::internal {

struct HarmonicTerm {
  int order = 1;               ///< k >= 0; an order may stand more than once
  Vec3 cosine = Vec3::Zero();  ///< A_k [m]
  Vec3 sine = Vec3::Zero();    ///< B_k [m]
};

struct Path {
  Vec3 center = Vec3::Zero();  ///< [m]
  double frequency = 0.0;      ///< w [rad/s]; zero: a point at rest
  double phase = 0.0;          ///< [rad]
  std::vector<HarmonicTerm> terms;
  std::shared_ptr<const PositionSpline> spline =
      nullptr;               ///< added; null: none. With one there are no terms.
  double spline_rate = 1.0;  ///< > 0; the spline is at spline_rate t + spline_lead
  double spline_lead = 0.0;  ///< [s]

  /// Position [m], velocity and acceleration at t [s]; exact derivatives. Allocates nothing.
  MotionPoint<Vec3> at(double t) const;
  /// What the acceleration changes by, at t [m/s^3].
  Vec3 jerk(double t) const;

  /// Whether it is a point at rest.
  bool rests() const { return !spline && (frequency == 0.0 || terms.empty()); }
  /// After which it is where it was [s]; 0: it rests, or never comes back.
  double period() const;
};

}  // namespace armtune::internal
