#pragma once
// The prescribed motion of a point over time. The point is the tool, a target or an obstacle. The motion is a
// finite sum of harmonics about a centre, which covers circles and similar curves,
//   p(t) = c + sum_k A_k cos(k phi) + B_k sin(k phi),   phi = w t + phase,
// or a motion through given points (knots), p(t) = c + spline(t).

#include <memory>
#include <vector>

#include "core/common/types.hpp"
#include "core/trajectory/motion_point.hpp"
#include "core/trajectory/position_spline.hpp"

namespace armtune::internal {

struct HarmonicTerm {
  int order = 1;               ///< k >= 0; several terms may have the same order
  Vec3 cosine = Vec3::Zero();  ///< A_k [m]
  Vec3 sine = Vec3::Zero();    ///< B_k [m]
};

struct Path {
  Vec3 center = Vec3::Zero();  ///< [m]
  double frequency = 0.0;      ///< w [rad/s]; zero: no harmonic motion
  double phase = 0.0;          ///< [rad]
  std::vector<HarmonicTerm> terms;
  std::shared_ptr<const PositionSpline> spline = nullptr;  ///< null: none. A path with a spline has no terms.
  double spline_rate = 1.0;  ///< > 0; the spline is evaluated at spline_rate * t + spline_lead
  double spline_lead = 0.0;  ///< [s]

  /// Returns position [m], velocity and acceleration at t [s]; the derivatives are exact. Allocates nothing.
  MotionPoint<Vec3> at(double t) const;
  /// Returns the jerk at t [m/s^3].
  Vec3 jerk(double t) const;

  /// True if the point never moves.
  bool rests() const { return !spline && (frequency == 0.0 || terms.empty()); }
  /// Returns the time after which the motion repeats [s]; 0 if the point never moves or the motion does not
  /// repeat.
  double period() const;
};

}  // namespace armtune::internal
