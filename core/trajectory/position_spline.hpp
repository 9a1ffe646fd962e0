#pragma once
// A point's motion through knots in time: quintics between them, so that position, velocity and acceleration
// go on without a jump from piece to piece.

#include <optional>
#include <utility>
#include <vector>

#include "core/common/types.hpp"
#include "core/trajectory/motion_point.hpp"
#include "core/trajectory/quintic.hpp"

namespace armtune::internal {

class PositionSpline {
 public:
  /// time [s]: of the knots, rising, at least two. knots: position [m], velocity, acceleration at each.
  /// loops: behind the last knot it goes on from the first, which has then the same motion. Throws InputError
  /// if the times do not rise, the counts differ, or a loop's ends differ by more than rounding.
  PositionSpline(const std::vector<double>& time, const std::vector<MotionPoint<Vec3>>& knots, bool loops);

  double begin() const { return time_.front(); }
  double end() const { return time_.back(); }
  bool loops() const { return loops_; }
  const std::vector<double>& time() const { return time_; }
  const std::vector<MotionPoint<Vec3>>& knots() const { return knots_; }

  /// At t [s]; before the start and after the end of one that does not loop it rests where it begins or ends.
  /// Allocates nothing; the piece is found by bisection.
  MotionPoint<Vec3> at(double t) const;
  /// At t [m/s^3]; it may jump at knots.
  Vec3 jerk(double t) const;

 private:
  /// The piece that t is in, and the time since its beginning; t: as `inside` leaves it.
  std::pair<std::size_t, double> piece(double t) const;
  /// t, of a loop brought into its first turn; nothing: outside, where it rests.
  std::optional<double> inside(double t) const;

  std::vector<double> time_;
  std::vector<MotionPoint<Vec3>> knots_;
  std::vector<Quintic<Vec3>> pieces_;
  bool loops_;
};

}  // namespace armtune::internal
