#pragma once
// The state a plan starts from.

#include "tuner/planning/tasks/plan_task.hpp"

namespace armtune {

struct StartState {
  JointVector position, velocity;
  JointVector acceleration;  ///< empty: free
};

/// As the task gives it: a state, a row of a rollout, or a pose on the path with the path's velocity. Throws
/// InputError.
StartState start_state(const PlanTask& task, const RobotModel& robot);

}  // namespace armtune
