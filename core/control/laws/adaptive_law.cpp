#include "core/control/laws/adaptive_law.hpp"

#include "core/control/adaptation.hpp"
#include "core/control/adaptation_filter.hpp"

namespace armtune::internal {
namespace {

class AdaptiveLaw final : public TorqueLaw {
 public:
  explicit AdaptiveLaw(const LawSetup& setup)
      : TorqueLaw(setup),
        gains_(setup.gains),
        period_(setup.period),
        filters_(setup.gains.adaptation_filter > 0.0),
        share_(filter_share(setup.gains.adaptation_filter, setup.period)),
        adaptation_(setup.theta) {
    filter_.start(setup.model.n());
  }

  void torque(const LawInput& in, JointVector& tau) override {
    const JointReference& reference = in.control.reference;
    slotine_li_forward(chain_, in.arm.poses, in.measured.qd, reference.velocity, reference.acceleration,
                       motion_);
    slotine_li_torque(chain_, in.arm.poses, motion_, adaptation_.theta(), tau);
    tau -= in.Kd.cwiseProduct(in.control.S);
    if (!filters_) return;
    filter_.take(share_, in.measured.qd, reference.velocity, reference.acceleration);
    filter_.motion(chain_, in.arm.poses, smoothed_);
  }

  void conclude(bool learning) override {
    if (!learning) return;
    adaptation_.step(filters_ ? smoothed_ : motion_, motion_, gains_.adaptation_gain, period_);
    if (gains_.adaptation_leakage > 0.0 || gains_.adaptation_inertia_leakage > 0.0) {
      adaptation_.leak(gains_.adaptation_leakage, gains_.adaptation_inertia_leakage, period_);
    }
    if (gains_.adaptation_projection) adaptation_.project();
  }

  const ParameterVector& theta() const override { return adaptation_.theta(); }
  bool contains_Kd() const override { return true; }
  const SlotineLi* references_motion() const override { return &motion_; }

 private:
  const Gains& gains_;
  double period_;
  bool filters_;
  double share_;  ///< of the filter
  AdaptationFilter filter_;
  SlotineLi smoothed_;
  Adaptation adaptation_;
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
