#pragma once
// The data of one control period of a rollout (one simulated scenario): the plant's true state, the
// controller's output and the resulting errors. Metrics and recordings are computed from these data.

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

  ToolAim aim() const { return {target_motion, orientation, mask == TaskMask::kPositionAndAxis}; }
};

}  // namespace armtune::internal
