#pragma once
// Computes the joint motion that a controller for joint trajectories tracks. With such a controller the arm
// can also perform tasks of the tool. The references of these tasks are joint velocities, which are
// integrated to positions here.

#include "core/control/laws/torque_law.hpp"

namespace armtune::internal {

class DesiredJoints {
 public:
  /// n: number of joints; period: control period [s].
  DesiredJoints(int n, double period) : period_(period), step_(JointVector::Zero(n)) {}

  /// Returns the desired position, velocity and acceleration (n each) of this period. In the state followPlan
  /// they are those of the plan. In other states the velocity and acceleration are the references, and the
  /// position is the integral of the reference velocity. This integral starts from the plan's last position
  /// if there was a plan, else from the measured position. While an obstacle repels the arm, the desired
  /// position is the measured one: the repulsion must move the arm, not stretch a spring. Call this function
  /// once per period. It allocates nothing after the first period.
  MotionPoint<JointVector> next(const LawInput& in) {
    const ControlOutput& control = in.control;
    if (control.state == ControlState::kFollowPlan) {
      reference_ = control.planned.position;
      step_.setZero();
      begun_ = true;
      return control.planned;
    }
    if (!begun_ || control.state == ControlState::kAvoidObstacles)
      reference_ = in.measured.q;
    else
      reference_ += step_;
    begun_ = true;
    step_ = period_ * control.reference.velocity;
    return {reference_, control.reference.velocity, control.reference.acceleration};
  }

 private:
  double period_;
  JointVector reference_, step_;
  bool begun_ = false;  ///< reference_ is from the last period
};

}  // namespace armtune::internal
