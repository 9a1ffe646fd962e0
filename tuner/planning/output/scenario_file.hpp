#pragma once
// Makes a scenario file in which the controller follows a planned trajectory. `armtune simulate` can then
// simulate the plan in closed loop.

#include <string>

#include "tuner/planning/tasks/plan_task.hpp"

namespace armtune::internal {

/// Returns the name of the scenario file in the plan's folder. Without .yaml, it is the
/// scenario's name in errors.csv and reports.
std::string planned_scenario_name(const PlanTask& task);

/// Returns the text of the scenario. It is based on the task's own scenario, and the controller follows
/// trajectory.csv beside the file until that ends. The controller starts from the parameters of the arm's
/// model.
std::string planned_scenario_yaml(const PlanTask& task);

}  // namespace armtune::internal
