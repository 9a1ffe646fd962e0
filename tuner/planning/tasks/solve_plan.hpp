#pragma once
// Solves the optimisation problem of a planning task. If the task fixes the duration, the plan of the least
// time may be solved first, to see whether that duration is long enough.

#include "tuner/planning/tasks/plan_problem.hpp"

namespace armtune::internal {

/// Returns the best trajectory found. If the task gives a duration that could be free, and it is near the
/// least time or below it, the plan of the least time is solved first. That plan is found more easily than
/// one of a given duration. It shows whether the given duration is too short, and it is the guess for the
/// plan of that duration.
PlannedTrajectory solve_plan(const PlanProblem& problem, const SequentialQuadraticOptions& options = {},
                             const PlanObserver& observer = {});

}  // namespace armtune::internal
