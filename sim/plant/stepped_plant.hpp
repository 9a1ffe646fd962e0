#pragma once
// A plant that is its accelerations: its state is advanced by one of our own fixed-step rules.

#include "sim/plant/plant.hpp"

namespace armtune {

class SteppedPlant : public Plant {
 public:
  /// n: joints. stepper: not Stepper::kReference, which is an engine's own.
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
    integrate(
        stepper_, dt,
        [&](const JointVector& q, const JointVector& qd, JointVector& qdd) {
          accelerations_at(at_q, q, qd, torque, qdd);
          at_q = nullptr;  // only the first stage is where the step starts
        },
        q_, qd_, work_);
  }

  /// Accelerations; poses: those at q, or null.
  virtual void accelerations_at(const Poses* /*poses*/, const JointVector& q, const JointVector& qd,
                                const JointVector& torque, JointVector& qdd) {
    accelerations(q, qd, torque, qdd);
  }

 private:
  Stepper stepper_;
  JointVector q_, qd_;
  StepWorkspace work_;
};

}  // namespace armtune
