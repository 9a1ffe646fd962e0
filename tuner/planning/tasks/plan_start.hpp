#pragma once
// The state a plan starts from.

#include "armtune/error.hpp"
#include "tuner/planning/tasks/controller_motion.hpp"
#include "tuner/planning/tasks/plan_task.hpp"

namespace armtune::internal {

/// The arm cannot be where the task wants it.
class OutOfReach : public InputError {
 public:
  using InputError::InputError;
};

struct StartState {
  JointVector position, velocity;  ///< n each [rad, m and per s]
  JointVector acceleration;        ///< empty: free
};

/// As the task gives it: where the controller was (null: no rollout), a state, or a pose on the path with the
/// path's velocity. Throws InputError, OutOfReach where no pose is on the path.
StartState start_state(const PlanTask& task, const RobotModel& robot, const ControllerMotion* controller);

/// Where the task has an arm at rest: zero (n) if jerks are limited, since accelerations then cannot jump;
/// else empty: any.
JointVector acceleration_at_rest(const PlanTask& task);

}  // namespace armtune::internal
