#pragma once
// A joint motion given at knots in time, with acceleration linear between them: what a planner by direct
// transcription writes and a controller follows.

#include <vector>

#include "core/common/types.hpp"
#include "core/trajectory/motion_point.hpp"

namespace armtune::internal {

class JointSpline {
 public:
  /// time [s]: of the knots, rising, at least two. knots: q, q', q'' of n joints at each (rad or m). Throws
  /// InputError if the times do not rise or the counts differ.
  JointSpline(std::vector<double> time, std::vector<MotionPoint<JointVector>> knots);

  double begin() const { return time_.front(); }
  double end() const { return time_.back(); }
  const std::vector<double>& time() const { return time_; }
  const std::vector<MotionPoint<JointVector>>& knots() const { return knots_; }

  /// q, q', q'' at t; before the start and after the end, those of the start and of the end. Allocates
  /// nothing; the knots about t are found by bisection.
  MotionPoint<JointVector> at(double t) const;

  /// Mean of q'' from t to t + dt, as far as the motion goes: the one acceleration that, held for so long,
  /// takes q' where it is meant to be. dt > 0.
  JointVector mean_acceleration(double t, double dt) const;

 private:
  std::vector<double> time_;
  std::vector<MotionPoint<JointVector>> knots_;
};

}  // namespace armtune::internal
