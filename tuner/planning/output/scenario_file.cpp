#include "tuner/planning/output/scenario_file.hpp"

#include <fmt/format.h>

#include "sim/scenario/data_files.hpp"
#include "sim/yaml/quoted.hpp"

namespace armtune::internal {

std::string planned_scenario_name(const PlanTask& task) {
  return "planned_" + task.name + ".yaml";
}

std::string planned_scenario_yaml(const PlanTask& task) {
  // Without a cell in the task's scenario, nothing would check the arm against itself.
  const bool needs_cell =
      !task.scenario.clearance && ClearanceModel(task.scenario.robot, Cell{}).has(Clearance::kSelf);
  return fmt::format(
      "base: {}\ndescription: {}\nplanned: trajectory.csv\nduration: planned   # or a time in s; if it is "
      "longer than the plan, the arm then follows the scenario's own path\ntheta_start: {{model_scale: 1}}\n{}",
      yaml::quoted(portable_reference(task.scenario.source)),
      yaml::quoted(fmt::format("follows the plan of {} with the joint space law", task.name)),
      needs_cell ? "cell: {}   # the arm must not touch itself\n" : "");
}

}  // namespace armtune::internal
