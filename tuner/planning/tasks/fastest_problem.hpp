#pragma once
// The plan of the least time for one turn along the tool path's curve. The speed along the curve is free.

#include "tuner/planning/tasks/plan_common.hpp"
#include "tuner/planning/tasks/plan_problem.hpp"

namespace armtune::internal {

/// Returns the problem. Throws InputError if the path stands still or never closes.
PlanProblem fastest_problem(const PlanCommon& common);

}  // namespace armtune::internal
