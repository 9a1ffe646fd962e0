#pragma once
// Planning tasks drawn at random, for comparing solvers: moves, moves past obstacles, switches of the gaze,
// returns, laps and fastest ways round a path, for the bundled arms of five, six and seven joints, under
// limits of velocity, effort, acceleration and jerk that are drawn as well.

#include <vector>

#include "tuner/planning/tasks/plan_problem.hpp"

namespace armtune::internal {

struct RandomPlan {
  PlanTask task;
  PlanProblem problem;
};

/// `count` tasks on `knots` knots, drawn by mt19937_64 from the seed. A draw that the arm cannot reach, or
/// that violates a limit or an obstacle's clearance where it starts or ends, is drawn again.
std::vector<RandomPlan> random_plans(int count, int knots, std::uint64_t seed);

}  // namespace armtune::internal
