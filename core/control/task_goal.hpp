#pragma once
// A joint goal that moves with the task: where the arm would be if it already followed the path and the gaze.
// leaveSingularity can end there, in the task's own motion, instead of at a pose that is the same for every
// task.
//
// Closed-loop inverse kinematics (Siciliano et al., Robotics: Modelling, Planning and Control, section 3.7)
// on a configuration of its own:  q' = J+ (xd' - K e),  q'' = J+ (xd'' - K e' - J' q'),  integrated from the
// start. It knows nothing of the joints' position limits, like the Cartesian law that takes over from it.

#include "core/control/roll_centering.hpp"
#include "core/control/task_resolution.hpp"
#include "core/control/tool_aim.hpp"

namespace armtune::internal {

class TaskGoal {
 public:
  /// Starts anew at q (n).
  void start(const JointVector& q) {
    motion_.position = q;
    motion_.velocity.setZero(q.size());
    step_.setZero(q.size());
  }

  /// The goal's q, q', q'' now, then one step of length dt [s]. path: desired tool motion, aim: where the
  /// tool is to be turned. damping: of the inverse. mask: the part of both that is the task. centering: of
  /// joints that it does not need. roll: turns the tool about its z axis as well; null: nothing does.
  const MotionPoint<JointVector>& step(const Chain& chain, const MotionPoint<Vec3>& path, const ToolAim& aim,
                                       const InverseDamping& damping, TaskMask mask,
                                       const JointCentering& centering, double dt,
                                       RollCentering* roll = nullptr);

 private:
  MotionPoint<JointVector> motion_;
  MeasuredArm arm_;
  JointReference reference_;
  JointVector step_;  ///< from the last configuration to the next
};

/// From `start` at rest (n) to a moving goal: (1 - s) start + s goal, with its derivatives. s: 0 to 1, at
/// rest at both ends.
MotionPoint<JointVector> towards(const JointVector& start, const MotionPoint<JointVector>& goal,
                                 const MotionPoint<double>& s);

}  // namespace armtune::internal
