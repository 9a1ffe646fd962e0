#pragma once
// Cartesian impedance without feed-forward, as a template for one arm or several at once (arm_law.hpp). The
// torque is
//   g(q) + (C(q, q') q' - J^T (K e + D J q') + N (k_N (q_N - q) - 2 sqrt(k_N) q')),
// and the rate of the part in brackets is limited. cartesian_impedance_law.hpp explains the law and its
// symbols. The desired pose is filtered arm by arm (tool_filter.hpp).

#include <cmath>

#include "core/common/cholesky6.hpp"
#include "core/common/products.hpp"
#include "core/control/laws/model_arm_law.hpp"
#include "core/control/laws/rigid_torque.hpp"
#include "core/control/laws/tool_filter.hpp"
#include "core/control/laws/torque_rate.hpp"

namespace armtune::internal {

template <typename T>
class CartesianImpedanceArmLawT final : public ModelArmLawT<T> {
 public:
  explicit CartesianImpedanceArmLawT(int n) : ModelArmLawT<T>(n), rate_(n), rigid_(n) {
    for (JointVectorT<T>* x : {&posture_, &free_, &command_}) x->setZero(n);
    J_.setZero(6, n);
  }

  /// Uses, in this order, the gains cartesian_impedance_k (6), _damping_ratio (6), _damping (6),
  /// _nullspace_k (1), _filter (1) and _torque_rate (1).
  void start(int lane, const LawNumbers& numbers) override {
    ModelArmLawT<T>::start(lane, numbers);
    const double* K = numbers.own[0];
    const double* ratio = numbers.own[1];
    const double* damping = numbers.own[2];
    const double nullspace_k = numbers.own[3][0];
    for (int axis = 0; axis < 6; ++axis) {
      this->put(lane, K[axis], K_[axis]);
      this->put(lane, damping[axis] + 2.0 * ratio[axis] * std::sqrt(K[axis]), D_[axis]);
    }
    this->put(lane, nullspace_k, nullspace_k_);
    this->put(lane, 2.0 * std::sqrt(nullspace_k), nullspace_d_);
    filters_[lane].start(numbers.own[4][0]);
    rate_.start(lane, numbers.own[5][0]);
    rigid_.start(lane, numbers.theta);
    this->mark(lane, false, tracked_tool_);
  }

  void torque(const LawPeriodT<T>& at, JointVectorT<T>& tau) override {
    const MaskT<T> tracks_tool = this->no(at.tracks_joints);
    rigid_.at_rest(at, tau);
    if (any(tracks_tool)) {
      follow_tool(at, tracks_tool);
      task_torque(at, tau);
    }
    if (any(at.tracks_joints)) {
      this->model_torque(at, at.qd, at.reference.velocity, at.reference.acceleration, of_joints_);
      for (Eigen::Index i = 0; i < tau.size(); ++i) {
        const T command = of_joints_[i] - (at.Kd[i] * at.S[i] + tau[i]);
        command_[i] = select(at.tracks_joints, command, command_[i]);
      }
    }
    rate_.limit(at.dt, command_, at.tracks_joints);
    tracked_tool_ = tracks_tool;
    for (Eigen::Index i = 0; i < tau.size(); ++i) tau[i] += command_[i];
  }

 private:
  /// Damping of the pseudo-inverse for the null space: the square of 0.2, as in the source.
  static constexpr double kNullSpaceDamping = 0.04;

  /// Computes the tool's error e of each arm that tracks its tool. An arm that did not track it in the last
  /// period starts from its present pose and joint positions.
  void follow_tool(const LawPeriodT<T>& at, const MaskT<T>& tracks_tool) {
    double R_0T[9];
    double p_0T[3];
    double pose_error[6];
    double e[6];
    for (int lane = 0; lane < LaneAccessT<T>::kLanes; ++lane) {
      if (!this->is_marked(lane, tracks_tool)) continue;
      this->get_all(lane, at.arm.poses.R_0T, R_0T);
      this->get_all(lane, at.arm.poses.p_0T, p_0T);
      this->get_all(lane, at.pose_error, pose_error);
      if (!this->is_marked(lane, tracked_tool_)) {
        filters_[lane].begin(R_0T, p_0T);
        for (Eigen::Index i = 0; i < posture_.size(); ++i)
          this->put(lane, this->get(lane, at.q[i]), posture_[i]);
      }
      filters_[lane].follow(R_0T, p_0T, pose_error, e);
      this->put_all(lane, e, error_);
    }
  }

  /// Computes the command of arms that track their tool. gravity (n): g(q).
  void task_torque(const LawPeriodT<T>& at, const JointVectorT<T>& gravity) {
    const TaskInverseT<T>& inverse = at.arm.inverse;
    for (Eigen::Index i = 0; i < J_.cols(); ++i) {
      J_.col(i) = inverse.of_task(at.arm.J.col(i));
      free_[i] = nullspace_k_ * (posture_[i] - at.q[i]) - nullspace_d_ * at.qd[i];
    }
    solver_.compute(damped_square(), 6);
    transposed_times(J_, solver_.solve(times(J_, free_)), bound_);
    const Vec6T<T> force =
        K_.cwiseProduct(inverse.of_task(error_)) + D_.cwiseProduct(inverse.of_task(at.arm.twist));
    transposed_times(J_, force, back_);
    rigid_.moving(at, at.qd, moving_);
    for (Eigen::Index i = 0; i < command_.size(); ++i) {
      command_[i] = free_[i] - bound_[i] + (moving_[i] - gravity[i] - back_[i]);
    }
  }

  /// Returns J J^T + 0.04 I. Only the lower triangle is set.
  typename Cholesky6T<T>::Matrix damped_square() const {
    typename Cholesky6T<T>::Matrix A;
    for (int row = 0; row < 6; ++row) {
      for (int column = 0; column <= row; ++column) {
        T sum = J_(row, 0) * J_(column, 0);
        for (Eigen::Index i = 1; i < J_.cols(); ++i) sum += J_(row, i) * J_(column, i);
        A(row, column) = sum;
      }
      A(row, row) += T(kNullSpaceDamping);
    }
    return A;
  }

  Vec6T<T> K_ = Vec6T<T>::Zero(), D_ = Vec6T<T>::Zero();
  T nullspace_k_{0.0}, nullspace_d_{0.0};
  ToolFilter filters_[LaneAccessT<T>::kLanes];
  TorqueRateT<T> rate_;
  RigidTorqueT<T> rigid_;
  MaskT<T> tracked_tool_{};  ///< in the last period
  JointVectorT<T> posture_;  ///< q_N
  Vec6T<T> error_ = Vec6T<T>::Zero();
  JacobianT<T> J_;  ///< of the task
  Cholesky6T<T> solver_;
  JointVectorT<T> command_;  ///< without gravity
  JointVectorT<T> free_;     ///< torque towards q_N
  JointVectorT<T> bound_;    ///< its part that would move the tool
  JointVectorT<T> back_, moving_, of_joints_;
};

}  // namespace armtune::internal
