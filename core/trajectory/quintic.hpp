#pragma once
// A quintic polynomial in time with given position, velocity and acceleration at its start and at its end.
// Siciliano et al., Robotics: Modelling, Planning and Control, section 4.2.1.

#include <algorithm>

#include "core/trajectory/motion_point.hpp"

namespace armtune::internal {

/// A quintic of V, a double or an Eigen vector. Times are in seconds from the polynomial's own start.
template <typename V>
class Quintic {
 public:
  /// duration > 0 [s].
  Quintic(const MotionPoint<V>& start, const MotionPoint<V>& end, double duration)
      : c0_(start.position), c1_(start.velocity), c2_(0.5 * start.acceleration), duration_(duration) {
    const double T = duration;
    // Differences at the end between the wanted motion and the parabola through the start.
    const V p = end.position - (c0_ + T * (c1_ + T * c2_));
    const V v = end.velocity - (c1_ + 2.0 * T * c2_);
    const V a = end.acceleration - 2.0 * c2_;
    const double T3 = T * T * T;
    c3_ = (10.0 * p - 4.0 * T * v + 0.5 * T * T * a) / T3;
    c4_ = (-15.0 * p + 7.0 * T * v - T * T * a) / (T3 * T);
    c5_ = (6.0 * p - 3.0 * T * v + 0.5 * T * T * a) / (T3 * T * T);
  }

  double duration() const { return duration_; }

  /// Returns the motion at t [s], which is clamped to the duration.
  MotionPoint<V> at(double t) const {
    const double s = std::clamp(t, 0.0, duration_);
    return {c0_ + s * (c1_ + s * (c2_ + s * (c3_ + s * (c4_ + s * c5_)))),
            c1_ + s * (2.0 * c2_ + s * (3.0 * c3_ + s * (4.0 * c4_ + s * (5.0 * c5_)))),
            2.0 * c2_ + s * (6.0 * c3_ + s * (12.0 * c4_ + s * (20.0 * c5_)))};
  }

  /// Returns the jerk at t, which is clamped to the duration.
  V jerk(double t) const {
    const double s = std::clamp(t, 0.0, duration_);
    return 6.0 * c3_ + s * (24.0 * c4_ + s * (60.0 * c5_));
  }

 private:
  V c0_, c1_, c2_, c3_, c4_, c5_;
  double duration_;
};

/// Returns the motion of a scalar that moves from `from` to `to` and rests at both ends.
inline Quintic<double> rest_to_rest(double from, double to, double duration) {
  return {MotionPoint<double>{from, 0.0, 0.0}, MotionPoint<double>{to, 0.0, 0.0}, duration};
}

/// Shortest duration of an interpolation [s]. Without it, a distance of zero would give a duration of zero.
inline constexpr double kShortestInterpolation = 0.05;

}  // namespace armtune::internal
