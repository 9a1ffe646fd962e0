#include "core/control/laws/arm_torque_law.hpp"

#include "core/control/adaptation_filter.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/joint_trajectory_law.hpp"
#include "core/control/laws/make_arm_law.hpp"
#include "core/control/laws/one_arm_period.hpp"
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
        period_(setup),
        drives_(make_drives(kind, setup)) {
    LawStorage storage;
    law_->start(0, law_numbers(setup, storage));
  }

  void torque(const LawInput& in, JointVector& tau) override {
    law_->torque(period_.of(in), tau);
    if (!drives_) return;
    if (drives_->needs_weight()) law_->weigh(period_.last(), weight_);
    drives_->begin(tau, in.measured, weight_);
    drives_->torque(in.measured, tau);
  }
  JointDrives* drives() override { return drives_ ? &*drives_ : nullptr; }

  void conclude(bool learning) override {
    law_->conclude(period_.last(), learning);
    if (learning && projects_) project_to_physical(law_->theta());
  }

  const ParameterVector& theta() const override { return law_->theta(); }
  bool contains_Kd() const override { return adaptive_; }
  const SlotineLi* references_motion() const override { return law_->references_motion(); }

 private:
  std::unique_ptr<ArmLawT<double>> law_;
  bool adaptive_;
  bool projects_;
  OneArmPeriod period_;
  std::optional<JointDrives> drives_;
  JointVector weight_;
};

}  // namespace

LawNumbers law_numbers(const LawSetup& setup, LawStorage& storage) {
  const Gains& gains = setup.gains;
  storage.own.clear();
  for (const JointVector& gain : gains.own) storage.own.push_back(gain.data());
  LawNumbers numbers{
      setup.theta.data(),
      storage.own.data(),
      gains.adaptation_gain,
      gains.adaptation_leakage,
      gains.adaptation_inertia_leakage,
      gains.adaptation_filter > 0.0 ? filter_share(gains.adaptation_filter, setup.period) : 0.0};
  if (is_joint_trajectory_controller(gains.controller)) {
    storage.joint_trajectory = jtc_numbers(setup.model, gains);
    numbers.joint_trajectory = &storage.joint_trajectory;
  }
  return numbers;
}

std::optional<JointDrives> make_drives(ArmLawKind kind, const LawSetup& setup) {
  if (!commands_drives(kind)) return {};
  if (kind == ArmLawKind::kJointTrajectoryVelocity) {
    return JointDrives(setup.model, setup.period, setup.drives);
  }
  return JointDrives(setup.model, setup.period, setup.drives,
                     {own(setup.gains, "servo_gain")[0], own(setup.gains, "servo_lookahead_time")[0]},
                     own(setup.gains, "servo_position_gain")[0]);
}

std::unique_ptr<TorqueLaw> make_torque_law(ArmLawKind kind, const LawSetup& setup) {
  return std::make_unique<ArmTorqueLaw>(kind, setup);
}

}  // namespace armtune::internal
