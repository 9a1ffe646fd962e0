#pragma once
// Start and goal where they are given whole: what rules them out is said before anything is solved.

#include "tuner/planning/tasks/plan_common.hpp"

namespace armtune::internal {

/// Throws InputError where the start is closer to an obstacle than the task allows, or where a joint cannot
/// give the torque that the start or the goal takes.
void check_given_states(const PlanCommon& common);

/// How far the arm at q (n) [rad, m] is at a time [s] from the nearest of the obstacles, by all points that a
/// plan keeps clear [m]; infinite without obstacles.
double clearance_at(const RobotModel& robot, const JointVector& q, double time,
                    const std::vector<MovingObstacle>& obstacles);

}  // namespace armtune::internal
