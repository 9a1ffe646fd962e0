#pragma once
// The base class of laws (arm_law.hpp) that do not adapt their model of the arm online: its parameters theta
// keep their start values.

#include "core/control/laws/arm_law.hpp"

namespace armtune::internal {

template <typename T>
class ModelArmLawT : public ArmLawT<T> {
 public:
  explicit ModelArmLawT(int n)
      : theta_(ParameterVectorT<T>::Zero((kLinkParameters + kJointParameters) * n)),
        rest_(JointVectorT<T>::Zero(n)) {}

  void start(int lane, const LawNumbers& numbers) override { this->put_all(lane, numbers.theta, theta_); }
  void weigh(const LawPeriodT<T>& at, JointVectorT<T>& weight) override {
    model_torque(at, rest_, rest_, rest_, weight);
  }
  ParameterVectorT<T>& theta() override { return theta_; }

 protected:
  /// Computes M(q) a + C(q, q') v + g(q) + friction(qd) (n) of the arm that theta describes.
  void model_torque(const LawPeriodT<T>& at, const JointVectorT<T>& qd, const JointVectorT<T>& v,
                    const JointVectorT<T>& a, JointVectorT<T>& tau) {
    slotine_li_forward(at.chain, at.arm.poses, qd, v, a, motion_);
    slotine_li_torque(at.chain, at.arm.poses, motion_, theta_, tau);
  }

  ParameterVectorT<T> theta_;
  JointVectorT<T> rest_;  ///< zeros
  SlotineLiT<T> motion_;
};

}  // namespace armtune::internal
