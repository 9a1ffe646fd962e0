#include "core/control/laws/adaptive_law.hpp"

#include "core/control/laws/adaptive_arms.hpp"

namespace armtune::internal {
namespace {

class AdaptiveLaw final : public TorqueLaw {
 public:
  explicit AdaptiveLaw(const LawSetup& setup)
      : TorqueLaw(setup),
        period_(setup.period),
        projects_(setup.gains.adaptation_projection),
        arm_(setup.model.n(), setup.theta) {
    arm_.set_rates(adaptive_rates(setup.gains, setup.period));
  }

  void torque(const LawInput& in, JointVector& tau) override {
    poses_ = &in.arm.poses;
    arm_.torque(chain_, *poses_, in.measured.qd, in.control.reference, in.Kd, tau);
  }

  void conclude(bool learning) override {
    arm_.adapt(chain_, *poses_, period_, learning);
    if (learning && projects_) arm_.adaptation().project();
  }

  const ParameterVector& theta() const override { return arm_.adaptation().theta(); }
  bool contains_Kd() const override { return true; }
  const SlotineLi* references_motion() const override { return &arm_.motion(); }

 private:
  double period_;
  bool projects_;
  AdaptiveArm arm_;
  const Poses* poses_ = nullptr;  ///< of the period
};

}  // namespace

ControllerKind adaptive_controller() {
  return {"adaptive",
          "adaptive Cartesian PID: Y theta - Kd S, with theta learnt on the way (Slotine and Li)",
          {"task_space_gains_p", "task_space_gains_i", "task_space_gains_d", "interpolation_gain_scale",
           "adaptation_gain", "adapt_while_avoiding", "adaptation_leakage", "adaptation_inertia_leakage",
           "adaptation_filter", "adaptation_projection"},
          {},
          [](const LawSetup& setup) { return std::make_unique<AdaptiveLaw>(setup); },
          {},
          true};
}

}  // namespace armtune::internal
