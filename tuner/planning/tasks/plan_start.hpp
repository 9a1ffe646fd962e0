#pragma once
// Determines the state of the arm at the start of a plan: joint positions, velocities and accelerations.

#include "armtune/error.hpp"
#include "tuner/planning/tasks/controller_motion.hpp"
#include "tuner/planning/tasks/plan_task.hpp"

namespace armtune::internal {

/// The error that the arm cannot reach a point to which the task must bring its tool.
class OutOfReach : public InputError {
 public:
  using InputError::InputError;
};

struct StartState {
  JointVector position, velocity;  ///< n each [rad, m] and [rad/s, m/s]
  JointVector acceleration;        ///< n [rad/s^2, m/s^2]; empty: free
};

/// Returns the start state of the task. It is the first of these that is available:
/// - the state in the rollout (a simulation) that `controller` was read from (null: no rollout);
/// - the state that the task gives;
/// - for kMove, the scenario's start;
/// - a state in which the tool is on its path and its z axis (the gaze) points at the target. The arm then
///   moves with the path, or is at rest for kFastest.
/// Throws OutOfReach, which is an InputError, if no joint position puts the tool on its path.
StartState start_state(const PlanTask& task, const RobotModel& robot, const ControllerMotion* controller);

/// Returns the acceleration of an arm at rest. It is zero (n) if the task limits jerks, because accelerations
/// then cannot jump. Otherwise it is empty, which means free.
JointVector acceleration_at_rest(const PlanTask& task);

}  // namespace armtune::internal
