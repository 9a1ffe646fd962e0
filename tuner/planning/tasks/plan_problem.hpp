#pragma once
// A task as a program on a time grid, and where to start from.

#include <limits>

#include "tuner/planning/tasks/plan_task.hpp"
#include "tuner/planning/tasks/tool_motion.hpp"
#include "tuner/planning/transcription/refining_solver.hpp"

namespace armtune::internal {

struct PlanProblem {
  std::shared_ptr<const RobotModel> robot;  ///< as it really is in the scenario
  TaskOnGrid task;
  TimeGrid grid;
  Trajectory guess;
  MovingPoint gaze_target;  ///< what the plan looks at
  /// The target that the plan looks at is the active one until then [s]; what looks there later is of no use.
  double target_until = std::numeric_limits<double>::infinity();
  /// The same with its duration free, where one is given that could be.
  std::shared_ptr<const PlanProblem> free_duration;
};

/// Throws InputError if no pose of the arm is on the tool's path where the plan needs one, or a rollout does
/// not fit.
PlanProblem plan_problem(const PlanTask& task);

/// The target the gaze is to be at in time.
MovingPoint active_target(const Scenario& scenario);

}  // namespace armtune::internal
