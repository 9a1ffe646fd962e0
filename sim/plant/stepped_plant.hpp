#pragma once
// Base class for simulated arms (plants) that only compute joint accelerations. It integrates them over a
// control period by one of armtune's own fixed-step methods.

#include "core/robot/friction_step.hpp"
#include "sim/plant/plant.hpp"

namespace armtune::internal {

class SteppedPlant : public Plant {
 public:
  /// n: number of joints. stepper: any but Stepper::kReference, which an engine itself implements.
  SteppedPlant(int n, Stepper stepper)
      : stepper_(stepper), q_(JointVector::Zero(n)), qd_(JointVector::Zero(n)) {}

  void set_state(const JointVector& q, const JointVector& qd) final {
    q_ = q;
    qd_ = qd;
  }
  const JointVector& q() const final { return q_; }
  const JointVector& qd() const final { return qd_; }

 protected:
  void advance(const JointVector& torque, double dt, const Poses* poses) final {
    const Poses* at_q = poses;
    const FrictionStep<double> friction(dt, qd_);  // integrate() writes qd_ after the last evaluation
    integrate(
        stepper_, dt,
        [&](const JointVector& q, const JointVector& qd, JointVector& qdd) {
          evaluate(at_q, q, qd, torque, friction, qdd);
          at_q = nullptr;  // these poses are valid only at the start of the step
        },
        q_, qd_, work_);
  }

  /// Computes the accelerations qdd (n) for one stage of the integration. poses: poses of the arm at q, or
  /// null if they are not known. friction: joint friction over this step.
  virtual void evaluate(const Poses* poses, const JointVector& q, const JointVector& qd,
                        const JointVector& torque, const FrictionStep<double>& friction,
                        JointVector& qdd) = 0;

 private:
  Stepper stepper_;
  JointVector q_, qd_;
  StepWorkspace work_;
};

}  // namespace armtune::internal
