#pragma once
// Computes the true tool pose, tracking errors, gaze angle and clearance of one control period from the state
// of the simulated arm, not from noisy measurements. Metrics and recordings use these values.

#include "sim/rollout/running_rollout.hpp"

namespace armtune::internal {

/// Fills in the errors and the gaze angle of `o`. The tool's pose in o.poses, twist, control and
/// target_motion must be set. exact: true if the controller computed its gaze from exactly this pose and
/// target.
void see_errors(bool exact, Observation& o);

/// Completes the observations of one rollout, with a workspace of its own.
class TrueState {
 public:
  /// theta_true (13 n): parameters of the plant. Both arguments must outlive this object.
  TrueState(const RobotModel& model, const ParameterVector& theta_true)
      : chain_(model.chain), theta_true_(theta_true) {}

  /// Completes `o`, in which time, q, qd, control, theta, target and target_motion are set. If the controller
  /// measured the arm exactly, its kinematics and tracking errors are reused instead of computed again.
  void observe(const RunningRollout& running, const Controller& controller, Observation& o);

 private:
  const Chain& chain_;
  const ParameterVector& theta_true_;
  Poses poses_;
  Jacobian J_;
  SlotineLi motion_;
  ParameterVector theta_error_;
  JointVector torque_error_;
};

}  // namespace armtune::internal
