#include "tuner/cli/task_files.hpp"

#include <fmt/format.h>

#include "core/control/laws/starting_gains.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/default_task.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/yaml/quoted.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune::internal::cli {
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

# Gains that hold: the worst of the arm and six others at random counts, and one corner rollout for
# each stability margin must hold on the arm of the model.
robust: {{samples: 6, measure: worst}}
margins: {{delay_periods: 1, gain: 1.2, noise: 2, rate: 0.8}}

search:
  engine: native      # Simbody judges what is found
  max_evaluations: 200
  seed: 1
)";

std::string study_text(const RobotModel& robot, bool looks) {
  return fmt::format("description: {}\n", yaml::quoted("first gains for " + robot.name)) +
         fmt::format(kStudy,
                     fmt::arg("orientation_parameters", looks ? "  - {name: slerpDurationErrorGain}\n" : ""),
                     fmt::arg("orientation_terms", looks ? "  - {metric: error/orientation/max, weight: 1}\n"
                                                           "  - {metric: error/orientation/rms, weight: 1}\n"
                                                         : ""));
}

}  // namespace

void write_task_files(const std::shared_ptr<const RobotModel>& robot, const std::string& robot_file,
                      const std::string& folder) {
  const DefaultTask task = default_task(robot);
  const Gains gains = starting_gains(*robot, task.scenario.start_position, task.goal, task.manipulability);
  const FolderLock lock = make_run_folder(folder);
  write_text_file(folder + "/task.yaml", default_task_yaml(task, portable_reference(robot_file)));
  write_text_file(folder + "/gains.yaml",
                  gains_yaml(gains, {fmt::format("from the inertia and the limits of {}; a start, not tuned",
                                                 robot->name)}));
  write_text_file(folder + "/study.yaml", study_text(*robot, tracks_orientation(task.scenario.mask)));
  say(
      fmt::format("wrote {0}: task.yaml (a circle of {1:.3g} m), gains.yaml, study.yaml\nnext: armtune tune "
                  "{0}/study.yaml\n",
                  folder, task.scenario.path.terms[0].cosine.norm()));
}

}  // namespace armtune::internal::cli
