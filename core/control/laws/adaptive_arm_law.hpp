#pragma once
// The adaptive law of Slotine and Li, as a template for one arm or several at once (arm_law.hpp). Equations 5
// and 6 in NOTATION.md:
//   tau = Y theta - Kd S,   theta <- theta - gamma Y^T S dt.
// For its options and their sources see core/control/adaptation.hpp and adaptation_filter.hpp.

#include "core/control/adaptation.hpp"
#include "core/control/adaptation_filter.hpp"
#include "core/control/laws/arm_law.hpp"

namespace armtune::internal {

template <typename T>
class AdaptiveArmLawT final : public ArmLawT<T> {
 public:
  explicit AdaptiveArmLawT(int n)
      : adaptation_(ParameterVectorT<T>::Zero((kLinkParameters + kJointParameters) * n)) {
    filter_.start(n);
  }

  void start(int lane, const LawNumbers& numbers) override {
    this->put_all(lane, numbers.theta, adaptation_.start());
    this->put_all(lane, numbers.theta, adaptation_.theta());
    this->put(lane, numbers.adaptation_gain, gamma_);
    this->put(lane, numbers.adaptation_leakage, leakage_);
    this->put(lane, numbers.inertia_leakage, inertia_leakage_);
    this->put(lane, numbers.filter_share, filter_share_);
    leaks_ = any(leakage_ + inertia_leakage_ > T(0.0));
    filters_ = filter_share_ > T(0.0);
    filter_.rest(lane);
  }

  void torque(const LawPeriodT<T>& at, JointVectorT<T>& tau) override {
    slotine_li_forward(at.chain, at.arm.poses, at.qd, at.reference.velocity, at.reference.acceleration,
                       motion_);
    slotine_li_torque(at.chain, at.arm.poses, motion_, adaptation_.theta(), tau);
    for (Eigen::Index i = 0; i < tau.size(); ++i) tau[i] -= at.Kd[i] * at.S[i];
    if (any(filters_)) filter_.take(filter_share_, at.qd, at.reference.velocity, at.reference.acceleration);
  }

  void conclude(const LawPeriodT<T>& at, const MaskT<T>& learning) override {
    if (!any(learning)) return;
    const MaskT<T> filtered = this->both(learning, filters_);
    if (any(filtered)) {
      filter_.motion(at.chain, at.arm.poses, smoothed_);
      adaptation_.step(smoothed_, motion_, gamma_, at.dt, filtered);
    }
    const MaskT<T> unfiltered = this->both(learning, this->no(filters_));
    if (any(unfiltered)) adaptation_.step(motion_, motion_, gamma_, at.dt, unfiltered);
    if (leaks_) adaptation_.leak(leakage_, inertia_leakage_, at.dt, learning);
  }

  ParameterVectorT<T>& theta() override { return adaptation_.theta(); }
  const SlotineLiT<T>* references_motion() const override { return &motion_; }

 private:
  T gamma_{0.0}, leakage_{0.0}, inertia_leakage_{0.0}, filter_share_{0.0};
  bool leaks_ = false;
  MaskT<T> filters_{};
  AdaptationT<T> adaptation_;
  AdaptationFilterT<T> filter_;
  SlotineLiT<T> motion_, smoothed_;
};

}  // namespace armtune::internal
