#include "core/control/pose_search.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "core/robot/kinematics.hpp"
#include "core/trajectory/gaze.hpp"

namespace armtune::internal {
namespace {

constexpr unsigned kStarts = 30;
constexpr int kSteps = 200;
constexpr double kReached = 1e-9;     // m and rad
constexpr double kLongestStep = 0.3;  // rad or m, largest step of any joint
constexpr double kDamping = 1e-6;

/// Returns the range from which positions of a joint are drawn. For a revolute joint this is the part of its
/// range within half a turn of zero. If that is less than half of the range or of a turn, positions are drawn
/// from the lower limit on, over at most one turn.
std::pair<double, double> sampled_range(const RobotModel& robot, int joint) {
  const auto k = static_cast<std::size_t>(joint);
  const JointLimits& limits = robot.joints[k].limits;
  if (!limits.has_position) return {-M_PI, M_PI};
  if (robot.chain.motion[k] == JointMotion::kPrismatic) return {limits.lower, limits.upper};
  const double lower = std::max(limits.lower, -M_PI);
  const double upper = std::min(limits.upper, M_PI);
  const double turn = std::min(limits.upper - limits.lower, 2.0 * M_PI);
  if (upper - lower > 0.5 * turn) return {lower, upper};
  return {limits.lower, limits.lower + turn};
}

}  // namespace

bool reach_goal(const RobotModel& robot, const ToolGoal& goal, JointVector& q) {
  Poses poses;
  Jacobian J;
  for (int step = 0; step < kSteps; ++step) {
    forward_kinematics(robot.chain, q, poses);
    tool_jacobian(robot.chain, poses, J);
    Vec6 error = Vec6::Zero();
    error.head<3>() = goal.tool - poses.p_0T;
    if (goal.target) error.tail<3>() = gaze_turn(poses.R_0T, poses.p_0T, *goal.target);
    if (goal.orientation)
      error.tail<3>() = rotation_log(*goal.orientation * Eigen::Quaterniond(poses.R_0T).conjugate());
    if (error.norm() < kReached) return tightest_joint(robot, q).margin >= 0.0;
    if (goal.target) {
      // The shortest turn has no part about tool z. J's part along z is removed, or it would fix the roll.
      const Vec3 z = poses.R_0T.col(2);
      J.bottomRows<3>() -= z * (z.transpose() * J.bottomRows<3>());
    } else if (!goal.orientation) {
      J.bottomRows<3>().setZero();
    }
    const Eigen::Matrix<double, 6, 6> A =
        J * J.transpose() + kDamping * Eigen::Matrix<double, 6, 6>::Identity();
    Eigen::VectorXd change = J.transpose() * A.ldlt().solve(error);
    const double longest = change.lpNorm<Eigen::Infinity>();
    if (longest > kLongestStep) change *= kLongestStep / longest;
    q += change;
  }
  return false;
}

std::optional<JointVector> best_pose(const RobotModel& robot, const ToolGoal& goal, const JointVector& first,
                                     const std::function<double(const JointVector&)>& score) {
  std::optional<JointVector> best;
  double highest = -std::numeric_limits<double>::infinity();
  for (unsigned start = 0; start < kStarts; ++start) {
    JointVector q = start == 0 ? first : sample_position(robot, start);
    if (!reach_goal(robot, goal, q)) continue;
    const double scored = score(q);
    if (scored > highest) {
      best = q;
      highest = scored;
    }
  }
  return best;
}

JointVector sample_position(const RobotModel& robot, unsigned sample) {
  std::mt19937 generator(sample);  // the number of the sample is the seed
  JointVector q(robot.n());
  for (int i = 0; i < robot.n(); ++i) {
    const auto [lower, upper] = sampled_range(robot, i);
    q[i] = lower + (upper - lower) * std::generate_canonical<double, 53>(generator);
  }
  return q;
}

TightestJoint tightest_joint(const RobotModel& robot, const JointVector& q) {
  TightestJoint tightest;
  for (int i = 0; i < robot.n(); ++i) {
    const JointLimits& limits = robot.joints[static_cast<std::size_t>(i)].limits;
    if (!limits.has_position) continue;
    const double left = std::min(q[i] - limits.lower, limits.upper - q[i]) / (limits.upper - limits.lower);
    if (left < tightest.margin) tightest = {i, left};
  }
  return tightest;
}

}  // namespace armtune::internal
