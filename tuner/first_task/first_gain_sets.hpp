#pragma once
// Gains that are tried one after the other on an arm that has none: starting gains, and what differs from
// them by a few factors.

#include <vector>

#include "core/control/gains.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Factors (n, >= 1) on Kd under which a fifth of the arm's weight at `goal` (n) that the model lacks moves
/// no joint from there by more than a fiftieth of its range, or six times `start`'s: at rest Kd Kp e balances
/// it. 1 for joints without position limits.
JointVector holding_firmness(const RobotModel& robot, const JointVector& goal, const Gains& start);

/// Returns `start` under every set of factors that is tried, those first that are to be preferred: Kp and Kd,
/// the adaptation and both duration gains differ. `start` itself is the first. goal (n): joint positions
/// where the task begins.
std::vector<Gains> first_gain_sets(const RobotModel& robot, const JointVector& goal, const Gains& start);

}  // namespace armtune::internal
