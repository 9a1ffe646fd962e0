#pragma once
// The data of one control period of a rollout (one simulated scenario): the plant's true state, the
// controller's output and the resulting errors. Metrics and recordings are computed from these data.

#include <algorithm>
#include <span>

#include "core/control/laws/controller.hpp"
#include "sim/cell/clearance_watch.hpp"

namespace armtune::internal {

/// The joints at a period of the robot's drives between two control periods.
struct DriveInstant {
  double time = 0.0;      ///< [s]
  JointVector q, qd;      ///< true [rad, m; /s]
  JointVector commanded;  ///< torque before saturation [N m, N]
  JointVector torque;     ///< torque within the effort limits, which acts at once
  bool saturated() const { return !(torque.array() == commanded.array()).all(); }
};

struct Observation {
  double time = 0.0;                ///< [s]
  const JointVector* q = nullptr;   ///< true [rad, m]
  const JointVector* qd = nullptr;  ///< true
  const ControlOutput* control = nullptr;
  const JointVector* applied = nullptr;  ///< torque that acts now (delayed) [N m, N]
  const ParameterVector* theta = nullptr;
  /// For controllers that command velocities or positions: the periods of the robot's drives that begin
  /// between the previous control period and this one. The periods that begin together with a control period
  /// are left out.
  std::span<const DriveInstant> between;

  // From the true state, base frame.
  const Poses* poses = nullptr;                   ///< of all bodies; in sim/lanes only of the tool
  Vec6 twist = Vec6::Zero();                      ///< (v_0T, w_0T)
  std::size_t target = 0;                         ///< index of the active target
  MotionPoint<Vec3> target_motion;                ///< of the active target; NaN without targets
  const OrientationPoint* orientation = nullptr;  ///< desired orientation; null: the tool has a gaze target
  TaskMask mask = TaskMask::kPose;
  Vec6 error = Vec6::Zero();  ///< pose error (position, rotation vector); zero in states that track joints
  Vec6 error_rate = Vec6::Zero();        ///< (v - vd, w - wd); zero in states that track joints
  double gaze_angle = 0.0;               ///< [rad]
  const ClearanceWatch* cell = nullptr;  ///< smallest distances so far; null: the scenario has no cell
  double clearance = 0.0;  ///< distance of joints and tool, or of links, from obstacles [m]; infinite if none
  /// Torque error of the controller's model of the arm, |Y (theta_hat - theta)| [N m]. Y: regressor for the
  /// true motion and the references. theta_hat: the controller's parameters after the adaptation step of this
  /// period. theta: parameters of the simulated arm, including payload and friction.
  double compensation_error = 0.0;

  /// Calls visit(time, q, qd, commanded, torque) for each entry of `between`, and then for this control
  /// period. commanded, torque: before and after saturation.
  template <typename Visit>
  void each_instant(const Visit& visit) const {
    for (const DriveInstant& at : between) visit(at.time, at.q, at.qd, at.commanded, at.torque);
    visit(time, *q, *qd, control->commanded, control->torque);
  }
  /// True if a torque was saturated in this control period or in `between`.
  bool saturated() const {
    return control->saturated ||
           std::any_of(between.begin(), between.end(), [](const DriveInstant& at) { return at.saturated(); });
  }

  ToolAim aim() const { return {target_motion, orientation, mask == TaskMask::kPositionAndAxis}; }
};

}  // namespace armtune::internal
