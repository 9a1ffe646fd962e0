#pragma once
// Evaluates a planned motion at one time: the arm's joints and torques, its tool, its gaze and its distances
// from obstacles. The time need not be a knot (point of the time grid), because the motion between knots is
// an exact cubic.

#include <optional>

#include "sim/cell/clearance_watch.hpp"
#include "tuner/planning/tasks/plan_problem.hpp"

namespace armtune::internal {

/// The requirements of a task for the tool, besides the joints' limits.
struct ToolDemands {
  bool path = false;  ///< true if the tool must be on a path
  bool gaze = false;  ///< true if its z axis must point at a target
};
ToolDemands tool_demands(const PlanTask& task);

struct PlanSample {
  double time = 0.0;                    ///< time of the scenario [s]
  JointVector q, qd, qdd, jerk;         ///< (n) [rad, m and per s, s^2, s^3]; jerk: constant in its interval
  JointVector tau;                      ///< (n) by inverse dynamics [N m, N]
  double s = 0.0, sd = 0.0, sdd = 0.0;  ///< path coordinate (time on the path), if the task has one [s]
  Poses poses;                          ///< at q
  Vec3 desired = Vec3::Zero();          ///< position that the path gives the tool [m]
  Vec3 target = Vec3::Zero();           ///< position of the gaze target [m]
  double gaze = 0.0;                    ///< angle between tool z and the line to that target [rad]
  double clearance = INFINITY;  ///< least distance of tool and movable joint origins from obstacles [m]
  LeastClearances cell;         ///< distances of links from each other and the cell, if the task limits any
};

/// Computes samples of a plan. Each call overwrites the sample that the previous call returned.
class PlanSampler {
 public:
  /// Task, problem and trajectory must outlive the sampler.
  PlanSampler(const PlanTask& task, const PlanProblem& problem, const Trajectory& trajectory);

  /// Returns the sample at knot k, as the trajectory stores it. Its jerk is the jerk in the interval after
  /// the knot or, at the last knot, in the interval before it.
  const PlanSample& at_knot(Eigen::Index k);
  /// Returns the sample in interval k at the fraction `part` (0 .. 1) of its duration.
  const PlanSample& within(Eigen::Index k, double part);
  /// Returns the sample at t [s]. A time outside the trajectory is replaced by the nearer end.
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
