#pragma once
// Controls the roll of a tool that points at a target (the gaze). The gaze fixes the direction of the tool's
// z axis and leaves the turn about it, the roll, free. Without control the roll drifts: after closed laps of
// tool and target the joints do not return to where they were, and the last joint winds up until it reaches
// its position limit. RollCentering turns the tool about its z axis so that the last joint returns to the
// middle of its limits.
//
// If the last joint turns about the tool's z axis, a roll moves that joint alone: q_n' = c rho, where rho is
// the roll rate, and c is +1 or -1 depending on the direction of the joint's axis. The roll rate follows a
// desired rate rho*,
//   rho* = -c v tanh(k (q_n - m) / v),   rho' = (rho* - rho) / T,
// where m is the middle of the limits, k the gain, and v a tenth of the joint's velocity limit. rho therefore
// never exceeds v and never jumps. T = min(1 s, 1 / (4 k)) prevents q_n from overshooting the middle: for
// small offsets, the dynamics of q_n have the characteristic equation T s^2 + s + k = 0, whose roots are real
// for 4 k T <= 1.

#include "core/control/task_mask.hpp"
#include "core/robot/robot_model.hpp"
#include "core/trajectory/slerp.hpp"

namespace armtune::internal {

class RollCentering {
 public:
  /// gain: k [1/s], 0 for none. The control is off unless the task includes the whole pose and the last joint
  /// is revolute, has position limits and turns about the tool's z axis.
  RollCentering(const RobotModel& model, double gain, TaskMask mask);

  /// True if the control is on.
  bool is_on() const { return gain_ > 0.0; }

  /// Advances by one control period [s], with the joints measured at q (n). frozen_start: true during a slerp
  /// that interpolates from the orientation at its start. The roll since the start of the slerp is then added
  /// to the orientation of the slerp.
  void step(const JointVector& q, double period, bool frozen_start);

  /// Adds the roll to the desired orientation, its angular velocity and its angular acceleration.
  void add_to(OrientationPoint& desired) const;

  double rate() const { return rate_; }  ///< rho [rad/s]

 private:
  double gain_ = 0.0;
  double sign_ = 1.0;           ///< c
  double middle_ = 0.0;         ///< m [rad]
  double fastest_ = 0.0;        ///< v [rad/s]
  double time_constant_ = 1.0;  ///< T [s]
  double rate_ = 0.0;
  double acceleration_ = 0.0;  ///< rho' [rad/s^2]
  double since_start_ = 0.0;   ///< roll since a slerp started [rad]
};

}  // namespace armtune::internal
