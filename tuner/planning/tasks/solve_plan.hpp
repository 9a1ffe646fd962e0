#pragma once
// Solves the optimisation problem of a planning task. If the task fixes the duration, the plan of the least
// possible duration may be solved first, to see whether the fixed duration is long enough.

#include "tuner/planning/tasks/plan_problem.hpp"

namespace armtune::internal {

/// Returns the best trajectory found. If the task fixes a duration that could be free, a rough plan shows
/// whether this duration is near the least possible one or below it. If so, the plan of the least duration is
/// solved first, because it is found more easily than a plan of a fixed duration. If that plan takes longer
/// than the fixed duration, the fixed duration is too short. Otherwise that plan is the first guess for the
/// plan of the fixed duration.
PlannedTrajectory solve_plan(const PlanProblem& problem, const SequentialQuadraticOptions& options = {},
                             const PlanObserver& observer = {});

}  // namespace armtune::internal
