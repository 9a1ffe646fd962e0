#pragma once
// Determines the state of the arm at the start of a plan: joint positions, velocities and accelerations.

#include "armtune/error.hpp"
#include "tuner/planning/tasks/controller_motion.hpp"
#include "tuner/planning/tasks/plan_task.hpp"

namespace armtune::internal {

/// The error that the arm cannot reach a place that the task needs.
class OutOfReach : public InputError {
 public:
  using InputError::InputError;
};

struct StartState {
  JointVector position, velocity;  ///< n each [rad, m and per s]
  JointVector acceleration;        ///< empty: free
};

/// Returns the start state of the task. It is the first of these that is available:
/// - the state in the rollout that `controller` was read from (null: no rollout);
/// - the state that the task gives;
/// - for kMove, the scenario's start;
/// - a state in which the tool is on its path and the gaze is at the target. The arm then moves with the
///   path, or is at rest for kFastest.
/// Throws InputError; OutOfReach if no joint position puts the tool on its path.
StartState start_state(const PlanTask& task, const RobotModel& robot, const ControllerMotion* controller);

/// Returns the acceleration of an arm at rest: zero (n) if the task limits jerks, since accelerations then
/// cannot jump; else empty, which means free.
JointVector acceleration_at_rest(const PlanTask& task);

}  // namespace armtune::internal
