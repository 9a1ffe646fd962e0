#pragma once
// What goes into a control period and what comes out of it.

#include <span>

#include "core/control/cartesian_law.hpp"
#include "core/control/joint_space_law.hpp"
#include "core/control/obstacle.hpp"
#include "core/control/state_machine.hpp"
#include "core/trajectory/joint_spline.hpp"
#include "core/trajectory/path.hpp"
#include "core/trajectory/slerp.hpp"

namespace armtune::internal {

/// What the controller measures: n joint positions [rad, m] and velocities.
struct JointState {
  JointVector q;
  JointVector qd;
};

/// What the controller knows of its surroundings in one period, base frame.
struct Scene {
  const Path* path = nullptr;  ///< the tool's path, on the simulation's own time
  MotionPoint<Vec3> target{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< the active gaze target [m]
  std::span<const Obstacle> obstacles;
  /// Joint motion to begin with, on the simulation's own time; null: leaveSingularity. The same in every
  /// period.
  const JointSpline* plan = nullptr;
  /// The path's motion at this very time, if somebody has computed it already.
  const MotionPoint<Vec3>* on_path = nullptr;
  /// How the tool is to be turned, in place of a gaze at the target; null: there is a gaze.
  const OrientationPoint* orientation = nullptr;
};

/// Everything a recorder wants to see of one period.
struct ControlOutput {
  JointVector torque;     ///< what goes to the joints, inside the effort limits [N m, N]
  JointVector commanded;  ///< before saturation
  bool saturated = false;
  ControlState state = ControlState::kLeaveSingularity;
  bool slerping = false;
  MotionPoint<Vec3> desired;         ///< linear reference (the tool's own position in avoidObstacles)
  OrientationPoint desired_gaze;     ///< orientation reference; identity before a state tracks one
  Vec3 gaze_turn = Vec3::Zero();     ///< of the measured tool to its aim; of states that track one
  CartesianErrors errors;            ///< as the law saw them; zero in states that track joints
  MotionPoint<JointVector> planned;  ///< qd, qd', qd'' of followPlan; empty if it never was
  JointReference reference;          ///< qr', qr''
  JointVector S;                     ///< q' - qr'
  double manipulability = 0.0;
  bool damped = false;
  double obstacle_distance = 0.0;  ///< [m], infinite without obstacles
  double pace = 1.0;               ///< sigma of the velocity governor: rate at which interpolations go on
};

}  // namespace armtune::internal
