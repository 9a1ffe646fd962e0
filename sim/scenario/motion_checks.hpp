#pragma once
// Whether a joint motion that a user's file gives is one of the robot: within its limits, and without jumps.

#include "core/robot/robot_model.hpp"
#include "core/trajectory/joint_spline.hpp"
#include "sim/scenario/motion_points.hpp"

namespace armtune::internal {

class MotionChecks {
 public:
  /// Both outlive it. degrees: what to do where the file has degrees, for messages.
  MotionChecks(const RobotModel& robot, const MotionPoints& points, const char* degrees)
      : robot_(robot), points_(points), degrees_(degrees) {}

  /// Throws InputError naming the first point whose position is outside a joint's limits.
  void at_points() const;

  /// The same of the motion between points, whose acceleration is linear there: where each joint turns round.
  void between_knots() const;

  /// The same of any motion through the points: at 31 times between two of them.
  void between_points(const JointSpline& motion) const;

  /// Throws InputError naming the first point that is not where the one before leads, with acceleration that
  /// is linear in between.
  void steps() const;

 private:
  /// between: on the way to the next point.
  void check_position(int joint, double q, std::size_t point, bool between) const;

  const RobotModel& robot_;
  const MotionPoints& points_;
  const char* degrees_;
};

}  // namespace armtune::internal
