#include "core/control/laws/arm_torque_law.hpp"

#include <optional>

#include "core/control/adaptation_filter.hpp"
#include "core/control/laws/make_arm_law.hpp"
#include "core/control/state_machine.hpp"
#include "core/robot/physical_theta.hpp"

namespace armtune::internal {
namespace {

class ArmTorqueLaw final : public TorqueLaw {
 public:
  ArmTorqueLaw(ArmLawKind kind, const LawSetup& setup)
      : TorqueLaw(setup),
        law_(make_arm_law<double>(kind, setup.model.n())),
        adaptive_(kind == ArmLawKind::kAdaptive),
        projects_(adaptive_ && setup.gains.adaptation_projection),
        period_(setup.period) {
    std::vector<const double*> own;
    law_->start(0, law_numbers(setup.gains, setup.theta, setup.period, own));
  }

  void torque(const LawInput& in, JointVector& tau) override {
    const ControlOutput& control = in.control;
    at_.emplace(LawPeriodT<double>{chain_, in.arm, in.measured.q, in.measured.qd, control.reference,
                                   control.S, in.Kd, control.errors.pose, tracks_joints(control.state),
                                   control.state == ControlState::kAvoidObstacles, period_});
    law_->torque(*at_, tau);
  }

  void conclude(bool learning) override {
    law_->conclude(*at_, learning);
    if (learning && projects_) project_to_physical(law_->theta());
  }

  const ParameterVector& theta() const override { return law_->theta(); }
  bool contains_Kd() const override { return adaptive_; }
  const SlotineLi* references_motion() const override { return law_->references_motion(); }

 private:
  std::unique_ptr<ArmLawT<double>> law_;
  bool adaptive_;
  bool projects_;
  double period_;
  std::optional<LawPeriodT<double>> at_;  ///< arguments of the last torque()
};

}  // namespace

LawNumbers law_numbers(const Gains& gains, const ParameterVector& theta, double period,
                       std::vector<const double*>& own) {
  own.clear();
  for (const JointVector& gain : gains.own) own.push_back(gain.data());
  return {theta.data(),
          own.data(),
          gains.adaptation_gain,
          gains.adaptation_leakage,
          gains.adaptation_inertia_leakage,
          gains.adaptation_filter > 0.0 ? filter_share(gains.adaptation_filter, period) : 0.0};
}

std::unique_ptr<TorqueLaw> make_torque_law(ArmLawKind kind, const LawSetup& setup) {
  return std::make_unique<ArmTorqueLaw>(kind, setup);
}

}  // namespace armtune::internal
