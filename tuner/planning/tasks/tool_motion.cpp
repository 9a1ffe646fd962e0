#include "tuner/planning/tasks/tool_motion.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core/control/task_goal.hpp"
#include "core/trajectory/gaze.hpp"

namespace armtune {
namespace {

constexpr int kStarts = 30;
constexpr int kSteps = 200;
constexpr double kReached = 1e-9;     // m and rad
constexpr double kLongestStep = 0.3;  // rad, m, of any joint
constexpr double kInnerStep = 1e-3;   // s, of the inverse kinematics along a path

double manipulability(const Jacobian& J) {
  const Eigen::Matrix<double, 6, 6> A = J * J.transpose();
  return std::sqrt(std::max(0.0, A.determinant()));
}

/// Damped least squares (Wampler 1986) from q on; false if it does not get there.
bool reach(const RobotModel& robot, const Vec3& tool, const std::optional<Vec3>& target, JointVector& q,
           double& m) {
  Poses poses;
  Jacobian J;
  for (int step = 0; step < kSteps; ++step) {
    forward_kinematics(robot.chain, q, poses);
    tool_jacobian(robot.chain, poses, J);
    Vec6 error = Vec6::Zero();
    error.head<3>() = tool - poses.p_0T;
    if (target) error.tail<3>() = gaze_turn(poses.R_0T, poses.p_0T, *target);
    if (error.norm() < kReached) {
      m = manipulability(J);
      for (int i = 0; i < robot.n(); ++i) {
        const JointLimits& limits = robot.joints[static_cast<std::size_t>(i)].limits;
        if (limits.has_position && (q[i] < limits.lower || q[i] > limits.upper)) return false;
      }
      return true;
    }
    if (!target) J.bottomRows<3>().setZero();
    // The shortest turn has no part about tool z: J along it is left out, or it would hold the roll.
    if (target) {
      const Vec3 z = poses.R_0T.col(2);
      J.bottomRows<3>() -= z * (z.transpose() * J.bottomRows<3>());
    }
    const Eigen::Matrix<double, 6, 6> A = J * J.transpose() + 1e-6 * Eigen::Matrix<double, 6, 6>::Identity();
    const Vec6 force = A.ldlt().solve(error);
    Eigen::VectorXd change = J.transpose() * force;
    const double longest = change.lpNorm<Eigen::Infinity>();
    if (longest > kLongestStep) change *= kLongestStep / longest;
    q += change;
  }
  return false;
}

}  // namespace

std::optional<JointVector> pose_at(const RobotModel& robot, const Vec3& tool,
                                   const std::optional<Vec3>& target, const JointVector& first,
                                   BestPose best) {
  std::optional<JointVector> found;
  double best_score = -std::numeric_limits<double>::infinity();
  for (int start = 0; start < kStarts; ++start) {
    JointVector q = first;
    if (start > 0) {
      std::mt19937 generator(static_cast<unsigned>(start));  // its number names the start
      for (int i = 0; i < robot.n(); ++i) {
        const JointLimits& limits = robot.joints[static_cast<std::size_t>(i)].limits;
        const double lower = limits.has_position ? std::max(limits.lower, -M_PI) : -M_PI;
        const double upper = limits.has_position ? std::min(limits.upper, M_PI) : M_PI;
        q[i] = lower + (upper - lower) * std::generate_canonical<double, 53>(generator);
      }
    }
    double m = 0.0;
    if (!reach(robot, tool, target, q, m)) continue;
    const double score = best == BestPose::kLargestManipulability
                             ? m
                             : -((q - first).array().abs() / robot.velocity_limits().array()).maxCoeff();
    if (score > best_score) {
      found = q;
      best_score = score;
    }
  }
  return found;
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
      goal.step(robot.chain, tool(t), target(t), damping, mask, centering, dt);
      t += dt;
    }
    const MotionPoint<JointVector>& point =
        goal.step(robot.chain, tool(t), target(t), damping, mask, centering, 0.0);
    motion.position.col(k) = point.position;
    motion.velocity.col(k) = point.velocity;
  }
  return motion;
}

}  // namespace armtune
