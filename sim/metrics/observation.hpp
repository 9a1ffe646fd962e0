#pragma once
// The data of one control period of a rollout: the plant's true state, the controller's output and the
// resulting errors. Metrics and recordings are computed from it.

#include "core/control/laws/controller.hpp"
#include "sim/cell/clearance_watch.hpp"

namespace armtune::internal {

struct Observation {
  double time = 0.0;                ///< [s]
  const JointVector* q = nullptr;   ///< true [rad, m]
  const JointVector* qd = nullptr;  ///< true
  const ControlOutput* control = nullptr;
  const JointVector* applied = nullptr;  ///< torque that acts now (delayed) [N m, N]
  const ParameterVector* theta = nullptr;

  // From the true state, base frame.
  const Poses* poses = nullptr;                   ///< if arms run side by side (sim/lanes), the tool's alone
  Vec6 twist = Vec6::Zero();                      ///< (v_0T, w_0T)
  std::size_t target = 0;                         ///< index of the active target
  MotionPoint<Vec3> target_motion;                ///< of the active target; NaN without targets
  const OrientationPoint* orientation = nullptr;  ///< desired in place of a gaze; null: there is a gaze
  TaskMask mask = TaskMask::kPose;
  Vec6 error = Vec6::Zero();  ///< pose error (position, rotation vector); zero in states that track joints
  Vec6 error_rate = Vec6::Zero();        ///< (v - vd, w - wd); zero in states that track joints
  double gaze_angle = 0.0;               ///< [rad]
  const ClearanceWatch* cell = nullptr;  ///< smallest distances so far; null: the scenario has no cell
  double clearance = 0.0;  ///< of joint origins and tool, or of links [m], infinite without obstacles
  /// |Y (theta_hat - theta)| [N m]. theta_hat: after this period's step of the adaptation. theta: that of the
  /// simulated arm with payload and friction. Y: along the true motion and the references.
  double compensation_error = 0.0;

  ToolAim aim() const { return {target_motion, orientation, mask == TaskMask::kPositionAndAxis}; }
};

}  // namespace armtune::internal
