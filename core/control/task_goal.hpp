#pragma once
// A joint goal that moves with the task: where the arm would be if it already followed the path and the gaze.
// leaveSingularity can end there, in the task's own motion, instead of at a pose that is the same for every
// task.
//
// Closed-loop inverse kinematics (Siciliano et al., Robotics: Modelling, Planning and Control, section 3.7)
// on a configuration of its own:  q' = J+ (xd' - K e),  q'' = J+ (xd'' - K e' - J' q'),  integrated from the
// start. It knows nothing of the joints' position limits, like the Cartesian law that takes over from it.

#include "core/control/task_inverse.hpp"
#include "core/robot/kinematics.hpp"
#include "core/trajectory/gaze_motion.hpp"

namespace armtune {

class TaskGoal {
 public:
  /// Starts anew at q (n).
  void start(const JointVector& q) {
    motion_.position = q;
    step_.setZero(q.size());
  }

  /// The goal's q, q', q'' now, then one step of length dt [s]. path: desired tool motion, target: gaze
  /// target. damping: of the inverse.
  const MotionPoint<JointVector>& step(const Chain& chain, const MotionPoint<Vec3>& path,
                                       const MotionPoint<Vec3>& target, const InverseDamping& damping,
                                       double dt);

 private:
  MotionPoint<JointVector> motion_;
  Poses poses_;
  Jacobian J_;
  Jacobian J_dot_;
  TaskInverse inverse_;
  JointVector step_;  ///< from the last configuration to the next
};

/// From `start` at rest (n) to a moving goal: (1 - s) start + s goal, with its derivatives. s: 0 to 1, at
/// rest at both ends.
MotionPoint<JointVector> towards(const JointVector& start, const MotionPoint<JointVector>& goal,
                                 const MotionPoint<double>& s);

}  // namespace armtune
