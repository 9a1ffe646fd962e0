#pragma once
// Computes joint poses and motions by inverse kinematics. In them the tool follows a path while its z axis
// (the gaze) points at a target. Plans use them as first guesses.

#include <functional>
#include <optional>

#include "core/robot/robot_model.hpp"
#include "core/trajectory/motion_point.hpp"
#include "tuner/planning/transcription/trajectory.hpp"

namespace armtune::internal {

/// A moving point: position [m], velocity [m/s] and acceleration [m/s^2] at t [s].
using MovingPoint = std::function<MotionPoint<Vec3>(double t)>;

/// The criterion that picks the best of several poses.
enum class BestPose {
  kLargestManipulability,
  kSoonest,  ///< reached first from `first` at the velocity limits
};

/// Returns a joint position (n) within the limits that puts the tool at `tool` and, if a target is given,
/// points the tool's z axis at `target`. The search starts from `first` and from random positions, and the
/// best pose found is returned. No value if no start leads to a pose.
std::optional<JointVector> pose_at(const RobotModel& robot, const Vec3& tool,
                                   const std::optional<Vec3>& target, const JointVector& first,
                                   BestPose best);

/// Returns the motion from q (n) at the grid's start on, in which the tool follows `tool` and looks at
/// `target`. Its durations are those of the grid's phases.
Trajectory follow(const RobotModel& robot, const JointVector& q, const TimeGrid& grid,
                  const MovingPoint& tool, const MovingPoint& target);

}  // namespace armtune::internal
