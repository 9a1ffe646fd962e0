#pragma once
// Inverse kinematics: searches for joint positions at which the tool reaches a goal, by damped least squares
// (Wampler 1986; Nakamura and Hanafusa 1986). The search is repeated from many start positions, and the
// caller's score decides which result is best. It finds the start poses of scenarios and of planned motions.

#include <functional>
#include <optional>

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// The wanted pose of the tool, base frame [m].
struct ToolGoal {
  Vec3 tool = Vec3::Zero();
  std::optional<Vec3> target;  ///< point at which the tool's z axis aims; none: any orientation
  std::optional<Eigen::Quaterniond> orientation = std::nullopt;  ///< orientation, in place of a target
};

/// Changes q (n) until the tool is at the goal, with an error below 1e-9 m and rad. Returns false if q does
/// not converge, or if it converges to a position outside the position limits.
bool reach_goal(const RobotModel& robot, const ToolGoal& goal, JointVector& q);

/// Returns the joint positions (n) with the highest score among those that `reach_goal` finds from `first`
/// and from random starts. Positions with a score of NaN or -infinity are left out. Returns no value if none
/// is found. The result is reproducible.
std::optional<JointVector> best_pose(const RobotModel& robot, const ToolGoal& goal, const JointVector& first,
                                     const std::function<double(const JointVector&)>& score);

/// Returns element `sample` of a fixed pseudo-random series of joint positions (n) within the limits. A
/// revolute joint is varied over at most one turn, around zero if its limits allow that.
JointVector sample_position(const RobotModel& robot, unsigned sample);

/// The joint that is closest to a position limit. margin: its distance from that limit as a share of its
/// range. It is 0.5 in the middle, negative outside the limits, and 0.5 if no joint has limits.
struct TightestJoint {
  int joint = 0;
  double margin = 0.5;
};
TightestJoint tightest_joint(const RobotModel& robot, const JointVector& q);

}  // namespace armtune::internal
