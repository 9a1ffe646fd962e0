#pragma once
// Joint impedance, as a template for one arm or several at once (arm_law.hpp). The torque is
//   g(q) + k (qd - q) + D (velocity_factor * qd' - v) + coriolis_factor * C(q, q') q',
// where v is the filtered joint velocity. The rate of the torque without g(q) is limited.
// joint_impedance_law.hpp explains the law and its symbols.

#include <cmath>

#include "core/control/laws/desired_joints.hpp"
#include "core/control/laws/model_arm_law.hpp"
#include "core/control/laws/rigid_torque.hpp"
#include "core/control/laws/torque_rate.hpp"

namespace armtune::internal {

template <typename T>
class JointImpedanceArmLawT final : public ModelArmLawT<T> {
 public:
  explicit JointImpedanceArmLawT(int n) : ModelArmLawT<T>(n), rate_(n), rigid_(n), desired_(n) {
    for (JointVectorT<T>* x : {&k_, &d_, &velocity_, &command_}) x->setZero(n);
  }

  /// Uses, in this order, the gains joint_impedance_k (n), _d (n), _damping_ratio (n), _velocity_factor (1),
  /// _coriolis_factor (1), _filter (1) and _torque_rate (1).
  void start(int lane, const LawNumbers& numbers) override {
    ModelArmLawT<T>::start(lane, numbers);
    const double* k = numbers.own[0];
    const double* d = numbers.own[1];
    const double* ratio = numbers.own[2];
    for (Eigen::Index i = 0; i < k_.size(); ++i) {
      this->put(lane, k[i], k_[i]);
      this->put(lane, d[i] + 2.0 * ratio[i] * std::sqrt(k[i]), d_[i]);
      this->put(lane, 0.0, velocity_[i]);
    }
    this->put(lane, numbers.own[3][0], velocity_factor_);
    this->put(lane, numbers.own[4][0], coriolis_factor_);
    this->mark(lane, numbers.own[4][0] != 0.0, adds_coriolis_);
    this->put(lane, numbers.own[5][0], filter_);
    rate_.start(lane, numbers.own[6][0]);
    rigid_.start(lane, numbers.theta);
    desired_.start(lane);
  }

  void torque(const LawPeriodT<T>& at, JointVectorT<T>& tau) override {
    desired_.compute(at);
    for (Eigen::Index i = 0; i < k_.size(); ++i) {
      velocity_[i] = filter_ * velocity_[i] + (T(1.0) - filter_) * at.qd[i];
      command_[i] = k_[i] * (desired_.position()[i] - at.q[i]) +
                    d_[i] * (velocity_factor_ * desired_.velocity()[i] - velocity_[i]);
    }
    rigid_.at_rest(at, tau);
    if (any(adds_coriolis_)) {
      rigid_.moving(at, at.qd, moving_);
      for (Eigen::Index i = 0; i < k_.size(); ++i) {
        command_[i] =
            select(adds_coriolis_, command_[i] + coriolis_factor_ * (moving_[i] - tau[i]), command_[i]);
      }
    }
    rate_.limit(at.dt, command_);
    for (Eigen::Index i = 0; i < tau.size(); ++i) tau[i] += command_[i];
  }

 private:
  JointVectorT<T> k_, d_;
  T velocity_factor_{0.0}, coriolis_factor_{0.0};
  MaskT<T> adds_coriolis_{};
  T filter_{0.0};  ///< share of the last filtered velocity in the next
  TorqueRateT<T> rate_;
  RigidTorqueT<T> rigid_;
  DesiredJointsT<T> desired_;
  JointVectorT<T> velocity_;  ///< filtered q'
  JointVectorT<T> command_;   ///< without gravity
  JointVectorT<T> moving_;
};

}  // namespace armtune::internal
