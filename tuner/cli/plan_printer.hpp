#pragma once
// The output of `armtune plan` about the outcome of its session.

#include "tuner/planning/session/plan_session.hpp"

namespace armtune::internal::cli {

/// Prints the plan, or why there is none. Returns the exit code.
int print_plan(const PlanOutcome& outcome, const PlanSettings& settings);

}  // namespace armtune::internal::cli
