// The command `armtune init`, which writes a study from a robot, its controller's parameters and its motions.
// The user can change the study before tuning.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "tuner/cli/commands.hpp"
#include "tuner/cli/controller_study_options.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/named_choice.hpp"
#include "tuner/cli/resume.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/shell_words.hpp"

namespace armtune::internal::cli {

void add_init_command(CLI::App& app, int& exit_code) {
  auto inputs = std::make_shared<ControllerStudyInputs>();
  auto folder = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "init",
      "Write a study that tunes the controller of your robot, from the arm, its parameter file and motions");
  add_controller_study_options(*command, *inputs, true);
  add_joint_motion_controller_option(*command, inputs->kind)->excludes(command->get_option("--controllers"));
  command->add_option("--out", *folder, "new folder for the study")->required();
  command->footer(
      "The command writes study.yaml with the gains to tune, the objective and the constraints. For each\n"
      "motion it writes a scenario with assumed values of sensor noise and delay. If no file gives the\n"
      "arm's rotor inertia, it also writes robot.yaml with an estimate. With --controller it also writes\n"
      "gains.yaml. Change the values that differ on your robot, then tune. With the same options, 'armtune\n"
      "tune' writes a study and tunes it at once.\n\n"
      "Example:\n"
      "  armtune init --robot ur5e --controllers ros2_controllers.yaml --trajectory moves.csv --out mine\n"
      "  armtune tune mine/study.yaml --out runs/mine\n\n"
      "A UR robot that follows streamed positions (servoj) has no parameter file:\n"
      "  armtune init --robot ur5e --controller position_streaming --rate 500 --trajectory moves.csv --out mine");
  command->callback([inputs, folder, &exit_code] {
    const std::string study = write_study(*inputs, *folder);
    if (study.empty()) {
      exit_code = kInterrupted;
      return;
    }
    say(fmt::format("next: {} tune {}\n", program_name(), shell_word(study)));
  });
}

}  // namespace armtune::internal::cli
