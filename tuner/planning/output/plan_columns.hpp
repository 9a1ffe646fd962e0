#pragma once
// The one declaration of the columns of a plan's CSV files: name, unit, meaning, value.

#include "sim/rollout/columns.hpp"
#include "tuner/planning/output/plan_sample.hpp"

namespace armtune::internal {

struct PlanColumn {
  std::string name;  ///< a tree with '/', no commas
  std::string unit;
  std::string meaning;
  std::function<double(const PlanSample&)> value;
};

/// Of trajectory.csv: a row a knot, from which the motion between the knots follows exactly.
std::vector<PlanColumn> trajectory_columns(const PlanTask& task, const RobotModel& robot);

/// Of motion.csv: rows at even times, to look at; named as those of a rollout where they are the same.
std::vector<PlanColumn> motion_columns(const PlanTask& task, const RobotModel& robot);

/// Without their values, as columns.csv takes them.
std::vector<Column> described(const std::vector<PlanColumn>& columns);

}  // namespace armtune::internal
