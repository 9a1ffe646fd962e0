#pragma once
// A scenario in which the controller follows a plan, as input for `armtune simulate`.

#include <string>

#include "tuner/planning/tasks/plan_task.hpp"

namespace armtune::internal {

/// Returns the name of the file in the plan's folder. The scenario has the same name in errors.csv and
/// reports.
std::string planned_scenario_name(const PlanTask& task);

/// Returns the text of the scenario. It is based on the task's own scenario, and the controller follows
/// trajectory.csv beside the file until that ends. The controller starts from the parameters of the arm's
/// model.
std::string planned_scenario_yaml(const PlanTask& task);

}  // namespace armtune::internal
