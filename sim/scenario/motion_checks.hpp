#pragma once
// Checks that a joint motion from a user's file fits the robot: it stays within the joints' position limits
// and has no jumps.

#include "core/robot/robot_model.hpp"
#include "core/trajectory/joint_spline.hpp"
#include "sim/scenario/motion_points.hpp"

namespace armtune::internal {

class MotionChecks {
 public:
  /// robot and points must outlive this object. degrees: text that messages add if the numbers look like
  /// degrees.
  MotionChecks(const RobotModel& robot, const MotionPoints& points, const char* degrees)
      : robot_(robot), points_(points), degrees_(degrees) {}

  /// Throws InputError naming the first point that is outside a joint's position limits.
  void at_points() const;

  /// Throws InputError if the positions of a joint without position limits look like degrees. They do if they
  /// range over more than two turns, and if some mean velocity between two points exceeds the joint's
  /// velocity limit by more than the square root of 180 / pi. If the numbers are taken for degrees, the
  /// velocity is then closer to its limit, as a ratio, than if they are taken for radians. speed: factor on
  /// the speed of the motion.
  void unlimited_joints(double speed) const;

  /// Throws InputError if a joint leaves its position limits between two points. It assumes that the
  /// acceleration is linear in time between the points, and checks the positions where each joint reverses.
  void between_knots() const;

  /// Throws InputError if a joint leaves its position limits between two points. motion: any motion through
  /// the points. It is checked at 31 instants between each point and the next.
  void between_points(const JointSpline& motion) const;

  /// Throws InputError naming the first point that does not match the point before it. Two points match if a
  /// motion whose acceleration is linear in time leads from the first one to the position and velocity of the
  /// second one.
  void steps() const;

 private:
  /// between: true if the position is on the way to the next point.
  void check_position(int joint, double q, std::size_t point, bool between) const;

  const RobotModel& robot_;
  const MotionPoints& points_;
  const char* degrees_;
};

}  // namespace armtune::internal
