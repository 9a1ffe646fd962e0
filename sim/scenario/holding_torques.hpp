#pragma once
// Computes the torques that balance gravity while an arm stands still, at many joint positions within its
// limits. They show before any simulation where effort limits are too low or masses too large.

#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// The torque that holds one joint [N m, N] while the arm is still at joint positions q (n) [rad, m].
struct JointHold {
  int joint = 0;
  double torque = 0.0;  ///< its absolute value
  JointVector q;
};

/// Returns for each joint a position at which it needs nearly its largest holding torque.
std::vector<JointHold> heaviest_holds(const RobotModel& robot);

/// Throws InputError if the arm can hold itself at less than 5 % of a fixed series of joint positions. Hardly
/// any place for a task would then be found. The error names a joint at the position with the median load.
/// most_load: largest share of each joint's effort limit that may be needed to hold the arm (> 0).
void refuse_too_heavy(const RobotModel& robot, double most_load);

/// Returns the clause "TORQUE N m to hold the arm still at [...] deg, and its effort limit is EFFORT N m".
std::string compared_with_limit(const RobotModel& robot, const JointHold& hold);

/// Returns "N" for a joint that slides, and "N m" for one that turns.
const char* effort_unit(const RobotModel& robot, int joint);

}  // namespace armtune::internal
