#pragma once
// Computed torque in Cartesian space, as a template for one arm or several at once (arm_law.hpp). The torque
// is the inverse dynamics of the joint acceleration J+ (xr'' - D (x' - xr') - J' q'). Joint motion that the
// task leaves free is damped. While the controller tracks joint positions, the acceleration is qr'' - d S
// instead. computed_torque_law.hpp explains the law and its symbols.

#include "core/control/laws/model_arm_law.hpp"
#include "core/control/task_resolution.hpp"

namespace armtune::internal {

template <typename T>
class ComputedTorqueArmLawT final : public ModelArmLawT<T> {
 public:
  using ModelArmLawT<T>::ModelArmLawT;

  /// Uses the gains computed_torque_d (6) and computed_torque_joint_d (1).
  void start(int lane, const LawNumbers& numbers) override {
    ModelArmLawT<T>::start(lane, numbers);
    this->put_all(lane, numbers.own[0], D_);
    this->put(lane, numbers.own[1][0], d_);
  }

  void torque(const LawPeriodT<T>& at, JointVectorT<T>& tau) override {
    const Eigen::Index n = at.S.size();
    acceleration_.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) acceleration_[i] = at.reference.acceleration[i] - d_ * at.S[i];
    const MaskT<T> in_task = this->no(at.tracks_joints);
    if (any(in_task)) {
      const TaskInverseT<T>& inverse = at.arm.inverse;
      const Vec6T<T> s = times(at.arm.J, at.S);
      Vec6T<T> wanted = D_.cwiseProduct(inverse.of_task(s)) + times(at.arm.J_dot, at.S);
      for (int row = 0; row < 6; ++row) wanted[row] -= d_ * s[row];
      if (inverse.mask() == TaskMask::kPositionAndAxis) {
        wanted -= turning(Vec3T<T>(at.arm.twist.template tail<3>()), s);
      }
      inverse.apply(wanted, correction_);
      for (Eigen::Index i = 0; i < n; ++i) {
        acceleration_[i] = select(in_task, acceleration_[i] - correction_[i], acceleration_[i]);
      }
    }
    this->model_torque(at, at.qd, at.qd, acceleration_, tau);
  }

 private:
  Vec6T<T> D_ = Vec6T<T>::Zero();
  T d_{0.0};
  JointVectorT<T> acceleration_, correction_;
};

}  // namespace armtune::internal
