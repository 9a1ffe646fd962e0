#pragma once
// A planned motion as CSV.

#include <string>
#include <vector>

#include "tuner/planning/output/limit_use.hpp"
#include "tuner/planning/output/plan_columns.hpp"

namespace armtune::internal {

/// Text of trajectory.csv: a row a knot, every limit's ratio beside its value.
std::string trajectory_csv(const PlanTask& task, const PlanProblem& problem, const Trajectory& trajectory);

/// Text of motion.csv: the same motion at `rows` (>= 2) even times from its start to its end.
std::string motion_csv(const PlanTask& task, const PlanProblem& problem, const Trajectory& trajectory,
                       int rows);

/// Text of limits.csv: a row for every limit.
std::string limits_csv(const std::vector<LimitUse>& uses);
std::vector<Column> limits_columns();

}  // namespace armtune::internal
