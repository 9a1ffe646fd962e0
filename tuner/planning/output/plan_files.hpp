#pragma once
// Makes the texts of a planned motion's CSV files: trajectory.csv, motion.csv and limits.csv.

#include <string>
#include <vector>

#include "tuner/planning/output/limit_use.hpp"
#include "tuner/planning/output/plan_columns.hpp"

namespace armtune::internal {

/// Returns the text of trajectory.csv: one row per knot (point of the time grid). Velocities and torques are
/// also given as shares of the robot's limits.
std::string trajectory_csv(const PlanTask& task, const PlanProblem& problem, const Trajectory& trajectory);

/// Returns the values of motion_columns(), row by row, at `rows` (>= 2) evenly spaced times from the start of
/// the motion to its end.
std::vector<double> motion_rows(const PlanTask& task, const PlanProblem& problem,
                                const Trajectory& trajectory, int rows);

/// Returns the text of motion.csv, which has the rows of motion_rows().
std::string motion_csv(const PlanTask& task, const PlanProblem& problem, const Trajectory& trajectory,
                       int rows);

/// Returns the text of limits.csv, which has one row per limit.
std::string limits_csv(const std::vector<LimitUse>& uses);
/// Returns name, unit and meaning of every column of limits.csv.
std::vector<Column> limits_columns();

}  // namespace armtune::internal
