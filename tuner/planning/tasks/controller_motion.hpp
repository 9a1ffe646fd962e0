#pragma once
// What the controller did: the part of a rollout that a plan is to do better, as its start and first guess.

#include <optional>

#include "tuner/planning/tasks/plan_task.hpp"
#include "tuner/planning/transcription/trajectory.hpp"

namespace armtune::internal {

struct ControllerMotion {
  Trajectory motion;              ///< from the plan's start to the rollout's end, a knot a row
  std::optional<double> reached;  ///< after how long the controller was where the task ends [s]
};

/// From the rollout that the task starts from. Throws InputError if it does not have the task's start.
ControllerMotion controller_motion(const PlanTask& task, const RobotModel& robot);

}  // namespace armtune::internal
