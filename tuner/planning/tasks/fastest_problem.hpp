#pragma once
// Sets up the optimisation problem of a `fastest` task: the tool goes once around a closed path in the least
// time. The speed along the path is free.

#include "tuner/planning/tasks/plan_common.hpp"
#include "tuner/planning/tasks/plan_problem.hpp"

namespace armtune::internal {

/// Returns the problem. Throws InputError if the path is a fixed point or is not closed.
PlanProblem fastest_problem(const PlanCommon& common);

}  // namespace armtune::internal
