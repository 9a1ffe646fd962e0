#pragma once
// A moving goal for leaveSingularity, the joint motion with which the controller starts if it has no planned
// trajectory. The goal is where an arm would be that already follows the tool's path and desired orientation.
// leaveSingularity can end there, in the motion of the task, instead of at a pose that is the same for every
// task.
//
// The goal is computed by closed-loop inverse kinematics (Siciliano et al., Robotics: Modelling, Planning and
// Control, section 3.7) on a separate configuration:  q' = J+ (xd' - K e),  q'' = J+ (xd'' - K e' - J' q'),
// integrated from the start. It ignores the joints' position limits, like the Cartesian law that takes over
// from it.

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
  /// that belong to the task. centering: motion of joints that the task does not need. roll: also turns the
  /// tool about its z axis; null: no such turn.
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

/// Returns the motion from `start` at rest (n) to a moving goal: (1 - s) start + s goal, with its
/// derivatives. s: from 0 to 1, at rest at both ends.
MotionPoint<JointVector> towards(const JointVector& start, const MotionPoint<JointVector>& goal,
                                 const MotionPoint<double>& s);

}  // namespace armtune::internal
