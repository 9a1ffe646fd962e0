// The files of a first task.

#include <fmt/format.h>

#include "sim/csv/text_file.hpp"
#include "sim/rollout/applies.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/yaml/quoted.hpp"
#include "tuner/first_task/first_task.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune::internal {
namespace {

constexpr const char* kStudy = R"(gains: gains.yaml     # the start; it scores 1
scenarios: [task.yaml]

parameters:           # from the start's values; bounds of your own: {{name: ..., lower: ..., upper: ...}}
  - {{name: task_space_gains_p}}
  - {{name: task_space_gains_d}}
  - {{name: trajectoryDurationErrorGain}}
{orientation_parameters}
objective:
  - {{metric: error/position/max, weight: 1}}
  - {{metric: error/position/rms, weight: 1}}
{orientation_terms}  - {{metric: effort_rate/rms, weight: 0.5}}

constraints:
  - {{metric: joint_velocity/max_ratio, at_most: 0.9}}
  - {{metric: joint_position/min_margin, at_least: 0}}
  - {{metric: joint_effort/max_ratio, at_most: 0.9}}
{clearances}
# Gains that hold: the worst of the arm and six others at random counts, and one corner rollout for
# each stability margin must hold on the arm of the model.
robust: {{samples: 6, measure: worst}}
margins: {{delay_periods: 1, gain: 1.2, noise: 2, rate: 0.8}}

search:
  engine: native      # Simbody judges what is found
  max_evaluations: 200
  seed: 1
)";

/// Constraints for what the arm can touch.
std::string clearances(const Scenario& scenario) {
  std::string text;
  for (const Metric contact : kContactMetrics) {
    if (applies(contact, scenario)) text += fmt::format("  - {{metric: {}, at_least: 0}}\n", name(contact));
  }
  return text;
}

std::string study_text(const Scenario& scenario) {
  const RobotModel& robot = *scenario.robot;
  const bool looks = tracks_orientation(scenario.mask);
  return fmt::format("description: {}\n", yaml::quoted("first gains for " + robot.name)) +
         fmt::format(kStudy, fmt::arg("clearances", clearances(scenario)),
                     fmt::arg("orientation_parameters", looks ? "  - {name: slerpDurationErrorGain}\n" : ""),
                     fmt::arg("orientation_terms", looks ? "  - {metric: error/orientation/max, weight: 1}\n"
                                                           "  - {metric: error/orientation/rms, weight: 1}\n"
                                                         : ""));
}

}  // namespace

void write_first_task(const FirstTask& found, const std::string& folder) {
  const Scenario& scenario = found.task.scenario;
  const std::vector<std::string> comments = {
      fmt::format("from the inertia and the limits of {}; a start, not tuned", scenario.robot->name),
      fmt::format(
          "completes task.yaml in Simbody, with at most {:.2g} of the velocity limits and {:.2g} of the effort limits",
          found.metrics[Metric::kJointVelocityMaxRatio], found.metrics[Metric::kJointEffortMaxRatio])};
  const FolderLock lock = make_run_folder(folder);
  if (!found.robot_yaml.empty()) write_text_file(folder + "/robot.yaml", found.robot_yaml);
  write_text_file(folder + "/task.yaml", default_task_yaml(found.task, found.robot_file));
  write_text_file(folder + "/gains.yaml", gains_yaml(found.gains, comments));
  write_text_file(folder + "/study.yaml", study_text(scenario));
}

}  // namespace armtune::internal
