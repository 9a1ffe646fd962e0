#include "tuner/planning/output/plan_sample.hpp"

#include <algorithm>

#include "core/robot/dynamics.hpp"
#include "core/trajectory/gaze.hpp"
#include "tuner/planning/transcription/arm_terms.hpp"

namespace armtune::internal {
ToolDemands tool_demands(const PlanTask& task) {
  ToolDemands demands;
  demands.path = task.kind != PlanKind::kMove;
  demands.gaze = task.kind == PlanKind::kTrack || task.kind == PlanKind::kSwitch ||
                 (task.kind == PlanKind::kReturn && task.end_gaze);
  return demands;
}

PlanSampler::PlanSampler(const PlanTask& task, const PlanProblem& problem, const Trajectory& trajectory)
    : task_(task), problem_(problem), trajectory_(trajectory) {
  if (task.clearance > 0.0 && task.scenario.clearance) cell_.emplace(task.scenario.clearance);
}

const PlanSample& PlanSampler::at_knot(Eigen::Index k) {
  const Eigen::Index interval = std::min(k, trajectory_.position.cols() - 2);
  set(trajectory_.time[static_cast<std::size_t>(k)], trajectory_.position.col(k), trajectory_.velocity.col(k),
      trajectory_.acceleration.col(k), interval);
  return sample_;
}

const PlanSample& PlanSampler::within(Eigen::Index k, double part) {
  const auto& time = trajectory_.time;
  const auto from = static_cast<std::size_t>(k);
  return at(time[from] + part * (time[from + 1] - time[from]));
}

const PlanSample& PlanSampler::at(double t) {
  const auto& time = trajectory_.time;
  t = std::clamp(t, time.front(), time.back());
  const TrajectoryPoint point = point_at(trajectory_, t);
  const auto next = std::upper_bound(time.begin() + 1, time.end() - 1, t);
  set(t, point.position, point.velocity, point.acceleration, (next - time.begin()) - 1);
  return sample_;
}

void PlanSampler::set(double time, const Eigen::VectorXd& position, const Eigen::VectorXd& velocity,
                      const Eigen::VectorXd& acceleration, Eigen::Index interval) {
  const RobotModel& robot = *problem_.robot;
  const Eigen::Index n = robot.n();
  PlanSample& to = sample_;
  to.time = time;
  to.q = position.head(n);
  to.qd = velocity.head(n);
  to.qdd = acceleration.head(n);
  const auto k = static_cast<std::size_t>(interval);
  to.jerk =
      (trajectory_.acceleration.col(interval + 1).head(n) - trajectory_.acceleration.col(interval).head(n)) /
      (trajectory_.time[k + 1] - trajectory_.time[k]);
  if (position.size() > n) {
    to.s = position[n];
    to.sd = velocity[n];
    to.sdd = acceleration[n];
  }
  forward_kinematics(robot.chain, to.q, to.poses);
  inverse_dynamics(robot.chain, to.poses, to.qd, to.qdd, to.tau);
  // For kFastest, the path coordinate takes the place of the time.
  to.desired = task_.scenario.path.at(task_.kind == PlanKind::kFastest ? task_.at + to.s : time).position;
  to.target = problem_.gaze_target(time).position;
  to.gaze = gaze_angle(to.poses.R_0T, to.poses.p_0T, to.target);
  if (cell_) {
    cell_->see(time, to.q);
    to.cell = cell_->least();
  }
  to.clearance = clearance_at(robot.chain, to.poses, time, task_.scenario.obstacles);
}

}  // namespace armtune::internal
