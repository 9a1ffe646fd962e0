#pragma once
// Lists the gain sets that are tried one after the other on an arm that has no gains yet: gains computed from
// the arm's inertia (starting_gains.hpp), and variants in which some of these gains are multiplied by
// factors.

#include <vector>

#include "core/control/gains.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Returns factors (n, 1 to 6) on the Kd of `start`, for a controller whose model lacks a fifth of the arm's
/// weight. At rest, a position error e remains, whose torque Kd * Kp * e balances the missing weight. Each
/// factor is the smallest with which e at `goal` (n) is at most a fiftieth of the joint's range, but at most
/// 6. It is 1 for joints without position limits.
JointVector holding_firmness(const RobotModel& robot, const JointVector& goal, const Gains& start);

/// Returns `start` multiplied by each set of factors that is tried, preferred sets first. The factors change
/// Kp and Kd, the adaptation gain, and the two gains that set the durations of a return to the path and of a
/// turn to a target. The first result is `start` itself. goal (n): joint positions where the task begins.
std::vector<Gains> first_gain_sets(const RobotModel& robot, const JointVector& goal, const Gains& start);

}  // namespace armtune::internal
