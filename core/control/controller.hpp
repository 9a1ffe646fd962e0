#pragma once
// The complete controller: state machine, references of the active state, adaptive torque law
//   tau = -Kd S + Y theta (+ repulsion), saturated at the effort limits (equation 6).

#include <memory>

#include "core/control/adaptation.hpp"
#include "core/control/control_logic.hpp"

namespace armtune {

class Controller {
 public:
  /// gains must be valid for the model (see validate). theta (13 n): start of the adaptation. period: control
  /// period [s].
  Controller(std::shared_ptr<const RobotModel> model, const Gains& gains, const ParameterVector& theta,
             double period, TaskMask mask = TaskMask::kPose);
  Controller(const Controller&) = delete;  // the inverse refers to this object's Jacobian
  Controller& operator=(const Controller&) = delete;

  /// One control period. Allocates nothing. The reference is valid until the next call.
  const ControlOutput& update(const JointState& measured, const Scene& scene, double time);

  const ParameterVector& theta() const { return adaptation_.theta(); }
  const Gains& gains() const { return logic_.gains(); }

  // Of the last period, for whoever looks at the same arm.
  const MeasuredArm& arm() const { return arm_; }
  const SlotineLi& motion() const { return motion_; }

 private:
  ControlLogic logic_;
  MeasuredArm arm_;
  SlotineLi motion_;
  Adaptation adaptation_;
};

}  // namespace armtune
