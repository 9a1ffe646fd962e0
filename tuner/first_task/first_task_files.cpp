// Writes the files of a first task.

#include <fmt/format.h>

#include "sim/csv/text_file.hpp"
#include "sim/scenario/default_task_file.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/first_task/first_study.hpp"
#include "tuner/first_task/first_task.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune::internal {

void write_first_task(const FirstTask& found, const std::string& folder) {
  const Scenario& scenario = found.task.scenario;
  const std::vector<std::string> comments = {
      fmt::format("start gains computed from inertia and limits of {}; not tuned", scenario.robot->name),
      fmt::format(
          "they complete task.yaml in Simbody with at most {:.2g} of the velocity limits and {:.2g} of "
          "the effort limits",
          found.metrics[Metric::kJointVelocityMaxRatio], found.metrics[Metric::kJointEffortMaxRatio])};
  const FolderLock lock = make_run_folder(folder);
  if (!found.robot_yaml.empty()) write_text_file(folder + "/robot.yaml", found.robot_yaml);
  write_text_file(folder + "/task.yaml", default_task_yaml(found.task, found.robot_file));
  write_text_file(folder + "/gains.yaml", gains_yaml(found.gains, comments));
  write_text_file(folder + "/study.yaml", first_study_yaml(scenario));
}

}  // namespace armtune::internal
