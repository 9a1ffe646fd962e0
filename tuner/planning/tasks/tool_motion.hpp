#pragma once
// Joint motions that follow a tool path with the gaze at a target, by inverse kinematics: what plans start
// from.

#include <functional>
#include <optional>

#include "core/robot/robot_model.hpp"
#include "core/trajectory/motion_point.hpp"
#include "tuner/planning/transcription/trajectory.hpp"

namespace armtune::internal {

/// A point that moves: position [m], velocity, acceleration at t [s].
using MovingPoint = std::function<MotionPoint<Vec3>(double t)>;

/// Which of several poses is the best.
enum class BestPose {
  kLargestManipulability,
  kSoonest,  ///< at the velocity limits, from the first start
};

/// A joint position (n) within the limits with the tool at `tool` and, where one is given, its z axis at
/// `target`; of those that are found from `first` and from random ones the best. None if no start leads
/// there.
std::optional<JointVector> pose_at(const RobotModel& robot, const Vec3& tool,
                                   const std::optional<Vec3>& target, const JointVector& first,
                                   BestPose best);

/// From q (n) at the grid's start on: the tool follows `tool` and looks at `target`. durations: of the grid's
/// phases.
Trajectory follow(const RobotModel& robot, const JointVector& q, const TimeGrid& grid,
                  const MovingPoint& tool, const MovingPoint& target);

}  // namespace armtune::internal
