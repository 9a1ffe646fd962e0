#pragma once
// Cartesian impedance, as a template for one arm or several at once (arm_law.hpp). The torque is
//   Y theta - J^T (K dx + D (x' - xd')) - B S,
// where B S is the torque of dampers in the joints. impedance_law.hpp explains the law and its symbols.

#include "core/control/laws/model_arm_law.hpp"

namespace armtune::internal {

template <typename T>
class ImpedanceArmLawT final : public ModelArmLawT<T> {
 public:
  explicit ImpedanceArmLawT(int n) : ModelArmLawT<T>(n) { B_.setZero(n); }

  /// Uses the gains impedance_k (6), impedance_d (6) and impedance_joint_d (n).
  void start(int lane, const LawNumbers& numbers) override {
    ModelArmLawT<T>::start(lane, numbers);
    this->put_all(lane, numbers.own[0], K_);
    this->put_all(lane, numbers.own[1], D_);
    this->put_all(lane, numbers.own[2], B_);
  }

  void torque(const LawPeriodT<T>& at, JointVectorT<T>& tau) override {
    this->model_torque(at, at.qd, at.reference.velocity, at.reference.acceleration, tau);
    const MaskT<T> in_task = this->no(at.tracks_joints);
    if (any(in_task)) {
      // Only the task's part counts: a free turn of the tool is not an error.
      const TaskInverseT<T>& inverse = at.arm.inverse;
      const Vec6T<T> dx = inverse.of_task(at.pose_error);
      const Vec6T<T> dx_dot = inverse.of_task(times(at.arm.J, at.S));
      const Vec6T<T> force = inverse.of_task(K_.cwiseProduct(dx) + D_.cwiseProduct(dx_dot));
      transposed_times(at.arm.J, force, back_);
    } else {
      back_.setZero(tau.size());
    }
    for (Eigen::Index i = 0; i < tau.size(); ++i) {
      tau[i] -= select(in_task, back_[i] + B_[i] * at.S[i], at.Kd[i] * at.S[i]);
    }
  }

  const SlotineLiT<T>* references_motion() const override { return &this->motion_; }

 private:
  Vec6T<T> K_ = Vec6T<T>::Zero(), D_ = Vec6T<T>::Zero();
  JointVectorT<T> B_, back_;
};

}  // namespace armtune::internal
