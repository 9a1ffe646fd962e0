#include "tuner/planning/tasks/tool_motion.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/control/pose_search.hpp"
#include "core/control/task_goal.hpp"
#include "core/control/task_inverse.hpp"

namespace armtune::internal {
namespace {

constexpr double kInnerStep = 1e-3;  // s, step of the inverse kinematics along a path

/// Returns the manipulability for the task components that the joints can control. looks: true if the tool's
/// z axis points at a target. With six or more joints, the task is the whole pose. The terms are then added
/// in another order than in TaskInverse. The order must not change, because rounding decides between equally
/// good poses.
double manipulability(const Jacobian& J, const Mat3& R_0T, bool looks) {
  if (J.cols() >= 6) {
    const Eigen::Matrix<double, 6, 6> A = J * J.transpose();
    return std::sqrt(std::max(0.0, A.determinant()));
  }
  TaskInverse inverse;
  inverse.compute(J, {0.0, 1.0, 0.0}, looks ? largest_mask(static_cast<int>(J.cols())) : TaskMask::kPosition,
                  R_0T);
  return inverse.manipulability();
}

}  // namespace

std::optional<JointVector> pose_at(const RobotModel& robot, const Vec3& tool,
                                   const std::optional<Vec3>& target, const JointVector& first,
                                   BestPose best) {
  return best_pose(robot, {tool, target}, first, [&](const JointVector& q) {
    if (best == BestPose::kSoonest)
      return -((q - first).array().abs() / robot.velocity_limits().array()).maxCoeff();
    Poses poses;
    Jacobian J;
    forward_kinematics(robot.chain, q, poses);
    tool_jacobian(robot.chain, poses, J);
    return manipulability(J, poses.R_0T, target.has_value());
  });
}

Trajectory follow(const RobotModel& robot, const JointVector& q, const TimeGrid& grid,
                  const MovingPoint& tool, const MovingPoint& target) {
  Trajectory motion;
  std::vector<double> times{grid.start};
  double phase_start = grid.start;
  for (const Phase& phase : grid.phases) {
    motion.durations.push_back(phase.duration);
    for (int i = 1; i <= phase.intervals; ++i)
      times.push_back(phase_start + phase.duration * i / phase.intervals);
    phase_start += phase.duration;
  }
  const auto knots = static_cast<Eigen::Index>(times.size());
  motion.time = times;
  motion.position.resize(robot.n(), knots);
  motion.velocity.resize(robot.n(), knots);
  motion.acceleration.setZero(robot.n(), knots);
  TaskGoal goal;
  goal.start(q);
  const InverseDamping damping{1e-3, 1e-3, 1.0};
  const TaskMask mask = largest_mask(robot.n());
  const JointCentering centering{JointVector::Zero(robot.n()), JointVector::Zero(robot.n())};
  double t = times.front();
  for (Eigen::Index k = 0; k < knots; ++k) {
    const double until = times[static_cast<std::size_t>(k)];
    while (t < until - 1e-12) {
      const double dt = std::min(kInnerStep, until - t);
      goal.step(robot.chain, tool(t), {target(t)}, damping, mask, centering, dt);
      t += dt;
    }
    const MotionPoint<JointVector>& point =
        goal.step(robot.chain, tool(t), {target(t)}, damping, mask, centering, 0.0);
    motion.position.col(k) = point.position;
    motion.velocity.col(k) = point.velocity;
  }
  return motion;
}

}  // namespace armtune::internal
