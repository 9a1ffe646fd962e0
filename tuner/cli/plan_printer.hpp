#pragma once
// Prints the result of `armtune plan`, which plans a trajectory with the least time or error.

#include "tuner/planning/session/plan_session.hpp"

namespace armtune::internal::cli {

/// Prints the planned trajectory, or why none was found. Returns the exit code.
int print_plan(const PlanOutcome& outcome, const PlanSettings& settings);

}  // namespace armtune::internal::cli
