#pragma once
// Fills an observation from the plant's true state.

#include "sim/rollout/observation.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune {

/// Work space and constants of the observation of one rollout.
class TrueState {
 public:
  /// theta_true (13 n): parameters of the plant. Both arguments must outlive this.
  TrueState(const RobotModel& model, const ParameterVector& theta_true)
      : chain_(model.chain), theta_true_(theta_true) {}

  /// Completes `o`, whose time, q, qd, control, theta, target and target_motion are set. centers: obstacles.
  void observe(std::span<const Vec3> centers, Observation& o);

 private:
  void track_errors(Observation& o) const;
  double compensation_error(const Observation& o);

  const Chain& chain_;
  const ParameterVector& theta_true_;
  Poses poses_;
  Jacobian J_;
  SlotineLi motion_;
  ParameterVector theta_error_;
  JointVector torque_error_;
};

}  // namespace armtune
