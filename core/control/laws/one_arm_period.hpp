#pragma once
// Converts the inputs of the torque law of one arm (torque_law.hpp) to those of a law that is a template for
// one arm or several (arm_law.hpp).

#include <optional>

#include "core/control/laws/arm_law.hpp"
#include "core/control/laws/plan_reader.hpp"
#include "core/control/laws/torque_law.hpp"

namespace armtune::internal {

class OneArmPeriod {
 public:
  explicit OneArmPeriod(const LawSetup& setup)
      : chain_(setup.model.chain), dt_(setup.period), plan_(setup.model.n(), setup.gains, setup.period) {}

  /// Returns the inputs of this period. They refer to those of `in`. Call it once per period. Allocates
  /// nothing.
  const LawPeriodT<double>& of(const LawInput& in) {
    const ControlOutput& control = in.control;
    at_.emplace(LawPeriodT<double>{chain_, in.arm, in.measured.q, in.measured.qd, control.reference,
                                   control.S, in.Kd, control.errors.pose,
                                   plan_.read(control, in.scene, in.time), tracks_joints(control.state),
                                   control.state == ControlState::kAvoidObstacles, dt_});
    return *at_;
  }
  /// Returns the inputs of the last period.
  const LawPeriodT<double>& last() const { return *at_; }

 private:
  const Chain& chain_;
  double dt_;  ///< control period [s]
  PlanReader plan_;
  std::optional<LawPeriodT<double>> at_;
};

}  // namespace armtune::internal
