#pragma once
// Computes joint positions and joint motions by inverse kinematics: poses in which the tool is at a point,
// and motions in which it follows a path, with its z axis (the gaze) on a target. Plans use the results as
// first guesses.

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
  kSoonest,  ///< reached from `first` in the least time at the velocity limits
};

/// Returns a joint position (n) within the limits that puts the tool at `tool` and, if a target is given,
/// points the tool's z axis at `target`. The search starts from `first` and from random positions. Returns
/// the best pose found, or nothing if no pose is found.
std::optional<JointVector> pose_at(const RobotModel& robot, const Vec3& tool,
                                   const std::optional<Vec3>& target, const JointVector& first,
                                   BestPose best);

/// Returns a motion that begins at joint positions q (n) at the start of the grid. The tool follows `tool`,
/// and its z axis points at `target`. The phases of the motion last as long as those of the grid.
Trajectory follow(const RobotModel& robot, const JointVector& q, const TimeGrid& grid,
                  const MovingPoint& tool, const MovingPoint& target);

}  // namespace armtune::internal
