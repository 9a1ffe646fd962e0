#pragma once
// Computes a moving goal for the state leaveSingularity. Without a planned trajectory the controller starts
// in this state, which moves the joints to a goal. The moving goal is the joint motion of an imaginary arm
// that already follows the tool's path and desired orientation. With it, the arm moves along the task's path
// when leaveSingularity ends. With a fixed goal instead, the state ends at rest, at a pose that is the same
// for every task.
//
// The goal is computed by closed-loop inverse kinematics (Siciliano et al., Robotics: Modelling, Planning and
// Control, section 3.7). The joint positions q of the imaginary arm are integrated from those that start()
// sets:
//   q' = J+ (xd' - K e),   q'' = J+ (xd'' - K e' - J' q'),   e: error of its tool.
// The goal ignores the joints' position limits, as the Cartesian law of the next state does.

#include "core/control/roll_centering.hpp"
#include "core/control/task_resolution.hpp"
#include "core/control/tool_aim.hpp"

namespace armtune::internal {

class TaskGoal {
 public:
  /// Restarts at q (n).
  void start(const JointVector& q) {
    motion_.position = q;
    motion_.velocity.setZero(q.size());
    step_.setZero(q.size());
  }

  /// Returns the goal's q, q', q'' now, and advances the goal by dt [s] for the next call. path: desired tool
  /// motion. aim: desired orientation. damping: damping of the inverse. mask: the components of path and aim
  /// that belong to the task. centering: null-space motion. roll: turns the tool about its z axis in
  /// addition; null: no such turn.
  const MotionPoint<JointVector>& step(const Chain& chain, const MotionPoint<Vec3>& path, const ToolAim& aim,
                                       const InverseDamping& damping, TaskMask mask,
                                       const JointCentering& centering, double dt,
                                       RollCentering* roll = nullptr);

 private:
  MotionPoint<JointVector> motion_;
  MeasuredArm arm_;
  JointReference reference_;
  JointVector step_;  ///< from this configuration to the next
};

/// Returns the motion from rest at `start` (n) to a moving goal: (1 - s) * start + s * goal, with its
/// derivatives. s: interpolation parameter from 0 to 1, at rest at both ends.
MotionPoint<JointVector> towards(const JointVector& start, const MotionPoint<JointVector>& goal,
                                 const MotionPoint<double>& s);

}  // namespace armtune::internal
