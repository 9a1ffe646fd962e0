#pragma once
// Declares the columns of a planned motion's CSV files, trajectory.csv and motion.csv: name, unit, meaning
// and value of each column.

#include "sim/rollout/columns.hpp"
#include "tuner/planning/output/plan_sample.hpp"

namespace armtune::internal {

struct PlanColumn {
  std::string name;  ///< parts separated by '/', without commas
  std::string unit;
  std::string meaning;
  std::function<double(const PlanSample&)> value;
};

/// Returns the columns of trajectory.csv, which has one row per knot (point of the time grid). The motion
/// between the knots follows exactly from these rows.
std::vector<PlanColumn> trajectory_columns(const PlanTask& task, const RobotModel& robot);

/// Returns the columns of motion.csv, whose rows are evenly spaced in time, for plots. Columns that also
/// exist in the CSV file of a rollout (a simulation) have the same names as there.
std::vector<PlanColumn> motion_columns(const PlanTask& task, const RobotModel& robot);

/// Returns the columns without their values, as columns.csv needs them.
std::vector<Column> described(const std::vector<PlanColumn>& columns);

}  // namespace armtune::internal
