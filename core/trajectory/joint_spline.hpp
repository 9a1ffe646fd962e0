#pragma once
// A joint motion given at knots in time. Between them its acceleration is linear, as a planner by direct
// transcription writes it, or it goes along segments as ROS's controllers make them.

#include <vector>

#include "core/common/types.hpp"
#include "core/trajectory/motion_point.hpp"
#include "core/trajectory/quintic.hpp"
#include "core/trajectory/ros_segments.hpp"

namespace armtune::internal {

class JointSpline {
 public:
  /// time [s]: of the knots, rising, at least two. knots: q, q', q'' of n joints at each (rad or m). Throws
  /// InputError if the times do not rise or the counts differ.
  JointSpline(std::vector<double> time, std::vector<MotionPoint<JointVector>> knots);

  /// Joins the knots as ros_segments does. given: what of each knot counts; the rest is taken as zero. From
  /// the end on the motion is that of the last knot. Throws as above.
  JointSpline(std::vector<double> time, std::vector<MotionPoint<JointVector>> knots, PointsGive given);

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
  std::vector<Quintic<JointVector>> segments_;  ///< none: acceleration is linear between knots
};

}  // namespace armtune::internal
