#pragma once
// A planned motion of an arm's joints, given by positions, velocities and accelerations at certain times, the
// knots. Between knots the acceleration is linear, as in trajectory optimisation by direct transcription.
// Alternatively the motion follows the polynomials of ROS's controllers (ros_segments.hpp), or jumps from
// knot to knot, as these controllers do if they do not interpolate.

#include <vector>

#include "core/common/types.hpp"
#include "core/trajectory/motion_point.hpp"
#include "core/trajectory/quintic.hpp"
#include "core/trajectory/ros_segments.hpp"

namespace armtune::internal {

/// The motion between the points of a trajectory of ROS. kNextPoint: from the time of each point on, the
/// motion has the state of the next point. This is what joint_trajectory_controller of ROS 2 does with
/// interpolation_method `none` (Trajectory::sample of ros2_controllers, Jazzy ed360c9 and Humble ad559d9).
enum class BetweenPoints { kInterpolated, kNextPoint };

class JointSpline {
 public:
  /// Makes a motion whose acceleration is linear between knots. time: times of the knots [s], increasing, at
  /// least two. knots: q, q', q'' of n joints at each time (rad or m). Throws InputError if the times do not
  /// increase or the counts differ.
  JointSpline(std::vector<double> time, std::vector<MotionPoint<JointVector>> knots);

  /// Makes a motion as ROS does: from the segments of ros_segments, or with jumps. given: the data of each
  /// knot that are used; the others are set to zero. From the end on, q, q' and q'' have the values of the
  /// last knot. Throws as above.
  JointSpline(std::vector<double> time, std::vector<MotionPoint<JointVector>> knots, PointsGive given,
              BetweenPoints between = BetweenPoints::kInterpolated);

  double begin() const { return time_.front(); }
  double end() const { return time_.back(); }
  const std::vector<double>& time() const { return time_; }
  const std::vector<MotionPoint<JointVector>>& knots() const { return knots_; }

  /// Returns q, q', q'' at t. Before the start and after the end, it returns the values of the start and of
  /// the end. With jumps, it returns the values of the next knot from the time of each knot on. Allocates
  /// nothing; the knots around t are found by bisection.
  MotionPoint<JointVector> at(double t) const;

  /// Returns the mean of q'' from t to t + dt, dt > 0. Time before the start and after the end of the motion
  /// is left out. If an arm has this constant acceleration during that time, its q' reaches the planned
  /// value.
  JointVector mean_acceleration(double t, double dt) const;

 private:
  std::vector<double> time_;
  std::vector<MotionPoint<JointVector>> knots_;
  std::vector<Quintic<JointVector>> segments_;  ///< empty: acceleration is linear between knots
  bool jumps_ = false;                          ///< true: the motion jumps from knot to knot
};

}  // namespace armtune::internal
