#pragma once
// The joint motion that a controller of joint trajectories tracks. Under such controllers the arm can also do
// tasks of the tool, whose references are joint velocities: these are then integrated to positions.

#include "core/control/laws/torque_law.hpp"

namespace armtune::internal {

class DesiredJoints {
 public:
  /// n: number of joints; period: control period [s].
  DesiredJoints(int n, double period) : period_(period), step_(JointVector::Zero(n)) {}

  /// Returns the desired position, velocity and acceleration (n each) of this period. Where a joint motion is
  /// followed (followPlan), it is that motion. In other states it is the reference velocity, and its integral
  /// from where the last motion ended, or from the measured position at the start. While an obstacle repels
  /// the arm, the desired position is the measured one: the repulsion must move the arm, not stretch a
  /// spring. Is called once per period. Allocates nothing after the first period.
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
