#pragma once
// The motion of a point through knots, each with a time, position, velocity and acceleration. The pieces
// between knots are quintics, so that position, velocity and acceleration are continuous.

#include <optional>
#include <utility>
#include <vector>

#include "core/common/types.hpp"
#include "core/trajectory/motion_point.hpp"
#include "core/trajectory/quintic.hpp"

namespace armtune::internal {

class PositionSpline {
 public:
  /// time [s]: times of the knots, increasing, at least two. knots: position [m], velocity and acceleration
  /// at each time. loops: true if the motion repeats from the first knot after it reaches the last one; both
  /// must then have the same values. Throws InputError if the times do not increase, the counts differ, or a
  /// loop's ends differ by more than rounding.
  PositionSpline(const std::vector<double>& time, const std::vector<MotionPoint<Vec3>>& knots, bool loops);

  double begin() const { return time_.front(); }
  double end() const { return time_.back(); }
  bool loops() const { return loops_; }
  const std::vector<double>& time() const { return time_; }
  const std::vector<MotionPoint<Vec3>>& knots() const { return knots_; }

  /// Returns the motion at t [s]. If the motion does not loop, the point rests at the first position before
  /// the start, and at the last position after the end. Allocates nothing; the piece is found by bisection.
  MotionPoint<Vec3> at(double t) const;
  /// Returns the jerk at t [m/s^3], which may jump at knots.
  Vec3 jerk(double t) const;

 private:
  /// Returns the index of the piece that holds t, and the time since its start. t: as returned by `inside`.
  std::pair<std::size_t, double> piece(double t) const;
  /// Returns the time at which the spline is evaluated for t. For a loop, this is t mapped into the first
  /// pass. Without a loop, it is t between start and end, and there is no value outside, where the point
  /// rests.
  std::optional<double> inside(double t) const;

  std::vector<double> time_;
  std::vector<MotionPoint<Vec3>> knots_;
  std::vector<Quintic<Vec3>> pieces_;
  bool loops_;
};

}  // namespace armtune::internal
