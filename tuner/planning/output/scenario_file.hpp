#pragma once
// Makes a scenario file in which the controller follows a planned trajectory. `armtune simulate` can use this
// file to simulate the plan in closed loop.

#include <string>

#include "tuner/planning/tasks/plan_task.hpp"

namespace armtune::internal {

/// Returns the name of the scenario file in the plan's folder. Without ".yaml" this is also the name of the
/// scenario in errors.csv and in reports.
std::string planned_scenario_name(const PlanTask& task);

/// Returns the text of the scenario file. The scenario is based on the task's own scenario. The controller
/// follows trajectory.csv, which is in the same folder, to its end. The controller's dynamic parameters start
/// at the values of the arm's model. If the task's scenario has no cell, and shapes of the arm are known,
/// this scenario has an empty cell, so that contact between links is checked.
std::string planned_scenario_yaml(const PlanTask& task);

}  // namespace armtune::internal
