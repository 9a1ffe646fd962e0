#pragma once
// Reads the motion of a controller from a rollout. A plan that is to improve on this motion takes its start
// and its first guess from it.

#include <optional>

#include "tuner/planning/tasks/plan_task.hpp"
#include "tuner/planning/transcription/trajectory.hpp"

namespace armtune::internal {

struct ControllerMotion {
  Trajectory motion;              ///< from the plan's start to the rollout's end, one knot per row
  std::optional<double> reached;  ///< kSwitch, kReturn: time until the controller met the task's end [s]
};

/// Returns the motion from the rollout that the task starts from. Throws InputError if the rollout has no row
/// within 0.05 s of the task's start, or a value after it that is not finite.
ControllerMotion controller_motion(const PlanTask& task, const RobotModel& robot);

}  // namespace armtune::internal
