#pragma once
// The gain sets that are tried one after the other on an arm that has no gains yet. They are the starting
// gains, and variants of them that differ by a few factors.

#include <vector>

#include "core/control/gains.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Returns factors (n, 1 to 6) on the Kd of `start`. With them no joint at `goal` (n) sags by more than a
/// fiftieth of its range under a fifth of the arm's weight that the model lacks, unless that takes a factor
/// above 6. At rest Kd Kp e balances this weight. The factor is 1 for joints without position limits.
JointVector holding_firmness(const RobotModel& robot, const JointVector& goal, const Gains& start);

/// Returns `start` under every set of factors that is tried, preferred ones first. Kp and Kd, the adaptation
/// and both duration gains differ. The first is `start` itself. goal (n): joint positions where the task
/// begins.
std::vector<Gains> first_gain_sets(const RobotModel& robot, const JointVector& goal, const Gains& start);

}  // namespace armtune::internal
