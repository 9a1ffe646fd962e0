#pragma once
// Joint PD with gravity compensation, as a template for one arm or several at once (arm_law.hpp). The torque
// is  g(q) + P (q_ref - q) + D (qr' - q'),  where q_ref is the integral of the reference velocity qr'.

#include "core/control/laws/model_arm_law.hpp"

namespace armtune::internal {

template <typename T>
class JointPdArmLawT final : public ModelArmLawT<T> {
 public:
  explicit JointPdArmLawT(int n) : ModelArmLawT<T>(n) {
    for (JointVectorT<T>* x : {&P_, &D_, &q_reference_, &step_}) x->setZero(n);
  }

  /// Uses the gains joint_pd_p (n) and joint_pd_d (n).
  void start(int lane, const LawNumbers& numbers) override {
    ModelArmLawT<T>::start(lane, numbers);
    this->put_all(lane, numbers.own[0], P_);
    this->put_all(lane, numbers.own[1], D_);
    this->put(lane, 1.0, fresh_);
  }

  void torque(const LawPeriodT<T>& at, JointVectorT<T>& tau) override {
    // While an obstacle repels the arm, q_ref follows the arm. Otherwise P would pull the arm back.
    const MaskT<T> from_here = this->either(at.yields, fresh_ > T(0.0));
    fresh_ = T(0.0);
    this->weigh(at, tau);
    for (Eigen::Index i = 0; i < tau.size(); ++i) {
      q_reference_[i] = select(from_here, at.q[i], q_reference_[i]);
      tau[i] += P_[i] * (q_reference_[i] - at.q[i]) - D_[i] * at.S[i];
      step_[i] = at.dt * at.reference.velocity[i];
    }
  }

  /// Advances the joint reference q_ref. While a joint is saturated, q_ref stops, because it would otherwise
  /// run ahead of the arm.
  void conclude(const LawPeriodT<T>& /*at*/, const MaskT<T>& learning) override {
    for (Eigen::Index i = 0; i < step_.size(); ++i) {
      q_reference_[i] = select(learning, q_reference_[i] + step_[i], q_reference_[i]);
    }
  }

 private:
  JointVectorT<T> P_, D_;
  JointVectorT<T> q_reference_, step_;
  T fresh_{1.0};  ///< above zero before the first period
};

}  // namespace armtune::internal
