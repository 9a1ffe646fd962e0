#pragma once
// A scenario in which the controller follows a plan: what `armtune simulate` takes.

#include <string>

#include "tuner/planning/tasks/plan_task.hpp"

namespace armtune::internal {

/// Name of the file in the plan's folder, which is the scenario's name in errors.csv and reports.
std::string planned_scenario_name(const PlanTask& task);

/// Text of the scenario: the task's own, followed along trajectory.csv beside the file, as long as that
/// lasts, by a controller that knows the arm.
std::string planned_scenario_yaml(const PlanTask& task);

}  // namespace armtune::internal
