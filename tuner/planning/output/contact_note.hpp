#pragma once
// States in words what a planned motion keeps its distance from, for whoever sends it to a robot.

#include <string>

#include "tuner/planning/tasks/plan_task.hpp"

namespace armtune::internal {

/// Returns one or more sentences: what the motion keeps away from at its knots, and what was not checked.
std::string contact_note(const PlanTask& task);

}  // namespace armtune::internal
