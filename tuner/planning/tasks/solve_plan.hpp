#pragma once
// A task, solved: a given duration is measured against the least first.

#include "tuner/planning/tasks/plan_problem.hpp"

namespace armtune::internal {

/// The best trajectory found. Where a duration is given that could be free, and it is near the least time or
/// below it, the plan of the least time comes first: it is found more easily than one of a given duration,
/// says whether that is too short, and is the guess for it.
PlannedTrajectory solve_plan(const PlanProblem& problem, const SequentialQuadraticOptions& options = {},
                             const PlanObserver& observer = {});

}  // namespace armtune::internal
