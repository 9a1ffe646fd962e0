#pragma once
// Start and goal where they are given whole: what rules them out is said before anything is solved.

#include "tuner/planning/tasks/plan_common.hpp"

namespace armtune {

/// Throws InputError where the start is closer to an obstacle than the task allows, or where a joint cannot
/// give the torque that the start or the goal takes.
void check_given_states(const PlanCommon& common);

}  // namespace armtune
