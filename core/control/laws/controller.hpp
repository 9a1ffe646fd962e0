#pragma once
// The complete controller of an arm. In every control period it decides its state, computes the references of
// that state, and applies the torque law that is selected with the gains. It adds the repulsion of obstacles,
// and limits the sum to the effort limits.

#include <memory>

#include "core/control/control_logic.hpp"
#include "core/control/laws/torque_law.hpp"

namespace armtune::internal {

class Controller {
 public:
  /// gains must be valid for the model (see validate). theta (13 n): parameters of the controller's model of
  /// the arm at the start. period: control period [s]. timing: rate and delay of the robot's drives, used if
  /// the law commands velocities or positions.
  Controller(std::shared_ptr<const RobotModel> model, const Gains& gains, const ParameterVector& theta,
             double period, TaskMask mask = TaskMask::kPose, const DriveTiming& timing = {});
  Controller(const Controller&) = delete;  // the inverse refers to this object's Jacobian
  Controller& operator=(const Controller&) = delete;

  /// Computes one control period. Allocates nothing. The result is valid until the next call.
  const ControlOutput& update(const JointState& measured, const Scene& scene, double time);

  /// True if the law commands velocities or positions, which the robot's drives follow.
  bool has_drives() const { return drives_ != nullptr; }
  /// Number of the drives' periods in a control period. The torque of update() acts in the first of them.
  int drive_steps() const { return has_drives() ? drives_->steps() : 1; }
  /// Computes the torques (n) [N m, N] of the drives' next period: before saturation, and within the effort
  /// limits. The repulsion of obstacles stays that of the control period. Must not be called without drives.
  /// Allocates nothing.
  void drive(const JointState& measured, JointVector& commanded, JointVector& torque) {
    drives_->next(measured, commanded, torque);
  }

  const ParameterVector& theta() const { return law_->theta(); }
  const Gains& gains() const { return logic_.gains(); }

  /// Returns Kd (n) of the last period if its torque contained -Kd S, else null.
  const JointVector* Kd() const { return law_->contains_Kd() ? &logic_.Kd() : nullptr; }

  // Results of the last period, for callers that need the same quantities of the arm.
  const MeasuredArm& arm() const { return arm_; }
  /// Returns the motion of the bodies that belongs to q', qr' and qr''. The regressor Y is computed from it.
  /// Null if the law has no regressor.
  const SlotineLi* references_motion() const { return law_->references_motion(); }

 private:
  ControlLogic logic_;
  MeasuredArm arm_;
  std::unique_ptr<TorqueLaw> law_;
  JointDrives* drives_;  ///< of law_, may be null
};

}  // namespace armtune::internal
