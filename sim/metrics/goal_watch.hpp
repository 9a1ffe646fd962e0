#pragma once
// Measures how the joints come to rest at the end of a planned motion, the goal: how long they need, and how
// far they overshoot it.

#include "core/trajectory/joint_spline.hpp"
#include "sim/metrics/metric.hpp"

namespace armtune::internal {

class GoalWatch {
 public:
  /// tolerance: distance from the goal within which a joint counts as settled [rad, m].
  GoalWatch(const JointSpline& plan, double tolerance);

  /// Adds the joint positions q (n) [rad, m] at t [s]. Times before the end of the plan have no effect.
  void add(double t, const JointVector& q);
  /// Writes the metrics goal/*. end: time at which the last period ends [s]. Without a time at or after the
  /// end of the plan, they stay empty (NaN).
  void write(double end, Metrics& m) const;

 private:
  double goal_time_;
  JointVector goal_;
  JointVector direction_;  ///< 1 or -1: sign of the last way to the goal that exceeds the tolerance; 0: none
  double tolerance_;
  bool seen_ = false;     ///< there was a time at or after the end of the plan
  bool outside_ = false;  ///< at the last of these times, a joint was not within the tolerance
  double settled_ = 0.0;  ///< first time within the tolerance after the last time outside [s]
  double overshoot_ = 0.0;
};

}  // namespace armtune::internal
