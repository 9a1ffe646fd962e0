#pragma once
// Joint positions that have the tool where it is wanted: damped least squares (Wampler 1986; Nakamura and
// Hanafusa 1986) from many starts. The best result is taken.

#include <functional>
#include <optional>

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Where the tool is wanted, base frame [m].
struct ToolGoal {
  Vec3 tool = Vec3::Zero();
  std::optional<Vec3> target;  ///< that its z axis points at; none: any orientation
  std::optional<Eigen::Quaterniond> orientation = std::nullopt;  ///< wanted whole, in place of a target
};

/// Moves q (n) to where the goal is met to 1e-9 m and rad. False: it does not get there, or not within the
/// position limits.
bool reach_goal(const RobotModel& robot, const ToolGoal& goal, JointVector& q);

/// Of the joint positions (n) that `reach_goal` finds from `first` and from random ones, the one with the
/// highest score; a position whose score is not a number, or -infinity, is left out. None: nothing was found.
/// The same call finds the same.
std::optional<JointVector> best_pose(const RobotModel& robot, const ToolGoal& goal, const JointVector& first,
                                     const std::function<double(const JointVector&)>& score);

/// Number `sample` of a fixed series of joint positions (n) within the limits; a joint that turns takes a
/// turn at most, about zero where it can.
JointVector sample_position(const RobotModel& robot, unsigned sample);

/// The joint that is closest to a position limit, and what is left to it as a share of its range: 0.5 in the
/// middle, negative outside. 0.5 where no joint has limits.
struct TightestJoint {
  int joint = 0;
  double margin = 0.5;
};
TightestJoint tightest_joint(const RobotModel& robot, const JointVector& q);

}  // namespace armtune::internal
