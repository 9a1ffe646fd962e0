#pragma once
// The arm at one time of a plan: at a knot, or between two of them, where the motion is an exact cubic.

#include <optional>

#include "sim/cell/clearance_watch.hpp"
#include "tuner/planning/tasks/plan_problem.hpp"

namespace armtune::internal {

/// What a task says of the tool, beside the joints' limits.
struct ToolDemands {
  bool path = false;  ///< the tool is to be on a path
  bool gaze = false;  ///< its z axis is to be at a target
};
ToolDemands tool_demands(const PlanTask& task);

struct PlanSample {
  double time = 0.0;             ///< of the scenario [s]
  JointVector q, qd, qdd, jerk;  ///< (n) [rad, m and per s, s^2, s^3]; jerk: of the interval it lies in
  JointVector tau;               ///< (n) by inverse dynamics [N m, N]
  double s = 0.0, sd = 0.0, sdd = 0.0;  ///< path coordinate in the path's own time, where there is one [s]
  Poses poses;                          ///< at q
  Vec3 desired = Vec3::Zero();          ///< where the path has the tool [m]
  Vec3 target = Vec3::Zero();           ///< where the gaze is to be [m]
  double gaze = 0.0;                    ///< angle between tool z and the line to that target [rad]
  double clearance = INFINITY;  ///< of joints' origins that can move, and the tool, from obstacles [m]
  LeastClearances cell;         ///< of the links from each other and the cell, where the task keeps some
};

class PlanSampler {
 public:
  /// Task, problem and trajectory must outlive it.
  PlanSampler(const PlanTask& task, const PlanProblem& problem, const Trajectory& trajectory);

  /// At knot k as it stands in the trajectory; the jerk is that of the interval after it, of the last one
  /// before.
  const PlanSample& at_knot(Eigen::Index k);
  /// Within interval k, at `part` (0 .. 1) of it.
  const PlanSample& within(Eigen::Index k, double part);
  /// At t [s], held at the ends outside.
  const PlanSample& at(double t);

 private:
  void set(double time, const Eigen::VectorXd& position, const Eigen::VectorXd& velocity,
           const Eigen::VectorXd& acceleration, Eigen::Index interval);

  const PlanTask& task_;
  const PlanProblem& problem_;
  const Trajectory& trajectory_;
  PlanSample sample_;
  std::optional<ClearanceNow> cell_;
};

}  // namespace armtune::internal
