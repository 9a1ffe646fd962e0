#pragma once
// Reads the motion of an arm under its controller from the CSV file of a simulation (rollout). A plan that is
// meant to improve this motion starts in the same state, and uses the motion as its first guess.

#include <optional>

#include "tuner/planning/tasks/plan_task.hpp"
#include "tuner/planning/transcription/trajectory.hpp"

namespace armtune::internal {

struct ControllerMotion {
  Trajectory motion;              ///< from the plan's start to the rollout's end; one point (knot) per row
  std::optional<double> reached;  ///< kSwitch, kReturn: time until the controller met the task's goal [s]
};

/// Returns the motion in the task's rollout, from the task's start to the rollout's end. Throws InputError if
/// the rollout has no row within 0.05 s of the task's start, or if a joint's position or velocity from there
/// on is not finite.
ControllerMotion controller_motion(const PlanTask& task, const RobotModel& robot);

}  // namespace armtune::internal
