#pragma once
// Least time along the tool path's curve: how fast it is gone is free.

#include "tuner/planning/tasks/plan_common.hpp"
#include "tuner/planning/tasks/plan_problem.hpp"

namespace armtune::internal {

/// Throws InputError if the path stands still.
PlanProblem fastest_problem(const PlanCommon& common);

}  // namespace armtune::internal
