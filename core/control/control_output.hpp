#pragma once
// The inputs of a controller in one control period (joint state and scene), and its outputs.

#include <span>

#include "core/control/cartesian_law.hpp"
#include "core/control/joint_space_law.hpp"
#include "core/control/obstacle.hpp"
#include "core/control/state_machine.hpp"
#include "core/trajectory/joint_spline.hpp"
#include "core/trajectory/path.hpp"
#include "core/trajectory/slerp.hpp"

namespace armtune::internal {

/// The measured joint state: n positions [rad, m] and velocities.
struct JointState {
  JointVector q;
  JointVector qd;
};

/// The controller's information about its surroundings in one period, in the base frame.
struct Scene {
  const Path* path = nullptr;  ///< the tool's path over simulated time
  MotionPoint<Vec3> target{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< the active gaze target [m]
  std::span<const Obstacle> obstacles;
  /// Planned joint motion over simulated time, which the controller follows first. If null, the controller
  /// starts in the state leaveSingularity instead. The plan is the same in every period.
  const JointSpline* plan = nullptr;
  /// True if the joints stay at the end of the plan. Otherwise the tool follows its path after the plan.
  bool holds_plan = false;
  /// The path's motion at this time if it has been computed already, else null.
  const MotionPoint<Vec3>* on_path = nullptr;
  /// Desired orientation of the tool. If null, the tool points at the target instead (the gaze).
  const OrientationPoint* orientation = nullptr;
};

/// The results of one control period, including all quantities that recordings contain.
struct ControlOutput {
  JointVector torque;     ///< sent to the joints, within the effort limits [N m, N]
  JointVector commanded;  ///< before saturation
  bool saturated = false;
  ControlState state = ControlState::kLeaveSingularity;
  bool slerping = false;
  MotionPoint<Vec3> desired;         ///< linear reference; the tool's own position if none is tracked
  OrientationPoint desired_gaze;     ///< orientation reference; identity before a state tracks one
  Vec3 gaze_turn = Vec3::Zero();     ///< turn from the measured tool to its aim, if the state has an aim
  CartesianErrors errors;            ///< as used by the law; zero in states that track joints
  MotionPoint<JointVector> planned;  ///< qd, qd', qd'' of followPlan; empty before its first period
  JointReference reference;          ///< qr', qr''
  JointVector S;                     ///< q' - qr'
  double manipulability = 0.0;
  bool damped = false;
  double obstacle_distance = 0.0;  ///< [m], infinite without obstacles
  double pace = 1.0;               ///< rate sigma at which the governor lets interpolation time run
};

}  // namespace armtune::internal
