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
  /// Time until which this target is the active one [s]. It is useless if the gaze reaches the target later.
  double target_until = std::numeric_limits<double>::infinity();
  /// The same problem with a free duration. Null unless the task fixes a duration that could be free.
  std::shared_ptr<const PlanProblem> free_duration;
};

/// Returns the problem of a task. Throws InputError if the arm cannot reach the tool's path where the plan
/// needs it to, if start or goal break the task's limits, or if a given rollout does not fit the task.
PlanProblem plan_problem(const PlanTask& task);

/// Returns the motion of the gaze target; at each time it is that of the active target.
MovingPoint active_target(const Scenario& scenario);

}  // namespace armtune::internal
