#pragma once
// Computes the joint motion that a controller for joint trajectories tracks, as a template for one arm or
// several at once (arm_law.hpp). Such a controller can also perform tasks of the tool, such as following a
// path. The references of these tasks are joint velocities, which are integrated to positions here.

#include "core/control/laws/arm_law.hpp"

namespace armtune::internal {

template <typename T>
class DesiredJointsT : LaneAccessT<T> {
 public:
  /// n: number of joints.
  explicit DesiredJointsT(int n) {
    for (JointVectorT<T>* x : {&position_, &velocity_, &step_}) x->setZero(n);
  }

  void start(int lane) { this->put(lane, 1.0, fresh_); }

  /// Computes the desired position and velocity (n each) of this period. In the state followPlan they are
  /// those of the plan. In other states the velocity is the reference, and the position is the integral of
  /// the reference velocity. This integral starts from the plan's last position if there was a plan, else
  /// from the measured position. While an obstacle repels the arm, the desired position is the measured one:
  /// the repulsion must move the arm, not stretch a spring. Call this function once per period. Allocates
  /// nothing.
  void compute(const LawPeriodT<T>& at) {
    const MaskT<T>& planned = at.planned.active;
    const MaskT<T> from_here = this->either(at.yields, fresh_ > T(0.0));
    fresh_ = T(0.0);
    for (Eigen::Index i = 0; i < position_.size(); ++i) {
      const T free = select(from_here, at.q[i], position_[i] + step_[i]);
      position_[i] = select(planned, at.planned.position[i], free);
      velocity_[i] = select(planned, at.planned.velocity[i], at.reference.velocity[i]);
      step_[i] = select(planned, T(0.0), at.dt * at.reference.velocity[i]);
    }
  }

  const JointVectorT<T>& position() const { return position_; }
  const JointVectorT<T>& velocity() const { return velocity_; }

 private:
  JointVectorT<T> position_, velocity_;
  JointVectorT<T> step_;  ///< change of the position until the next period
  T fresh_{1.0};          ///< above zero before the first period
};

}  // namespace armtune::internal
