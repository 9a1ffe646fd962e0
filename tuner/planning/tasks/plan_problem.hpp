#pragma once
// Turns a planning task into an optimisation problem on a time grid, with a first guess of the trajectory.

#include <limits>

#include "tuner/planning/tasks/plan_task.hpp"
#include "tuner/planning/tasks/tool_motion.hpp"
#include "tuner/planning/transcription/refining_solver.hpp"

namespace armtune::internal {

struct PlanProblem {
  std::shared_ptr<const RobotModel> robot;  ///< the scenario's true arm (payload, friction)
  TaskOnGrid task;
  TimeGrid grid;
  Trajectory guess;
  MovingPoint gaze_target;  ///< the target that the plan looks at
  /// Time until which this target is the active one [s]. A gaze that reaches it later is of no use.
  double target_until = std::numeric_limits<double>::infinity();
  /// The same problem with a free duration. Set if the task fixes a duration that could be free.
  std::shared_ptr<const PlanProblem> free_duration;
};

/// Returns the problem of a task. Throws InputError if no pose of the arm is on the tool's path where the
/// plan needs one, if start or goal break the task's limits, or if a rollout does not fit.
PlanProblem plan_problem(const PlanTask& task);

/// Returns the motion of the gaze target; at each time it is that of the active target.
MovingPoint active_target(const Scenario& scenario);

}  // namespace armtune::internal
