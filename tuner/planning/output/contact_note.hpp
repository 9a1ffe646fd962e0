#pragma once
// Writes a note for the person who sends a planned motion to a robot. It says which obstacles and bodies the
// motion keeps away from.

#include <string>

#include "tuner/planning/tasks/plan_task.hpp"

namespace armtune::internal {

/// Returns one or more sentences. They say what the motion keeps away from at its knots (points of the time
/// grid), and what was not checked.
std::string contact_note(const PlanTask& task);

}  // namespace armtune::internal
