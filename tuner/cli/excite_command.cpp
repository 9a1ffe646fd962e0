// The command `armtune excite`, which designs a trajectory for identifying an arm's dynamics, and simulates
// logs of it.

#include <CLI/CLI.hpp>
#include <memory>

#include "tuner/cli/commands.hpp"
#include "tuner/cli/excite_options.hpp"
#include "tuner/cli/excite_printer.hpp"
#include "tuner/cli/readable_file.hpp"
#include "tuner/cli/resume.hpp"

namespace armtune::internal::cli {
namespace {

int run_excite(const ExciteArguments& args) {
  const ExciteSettings settings = settings_of(args);
  ExcitePrinter printer;
  const ExciteOutcome outcome = ExciteSession(settings, session_context(), printer).run();
  printer.ended(settings, outcome);
  return static_cast<int>(outcome.ending);
}

}  // namespace

void add_excite_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<ExciteArguments>();
  CLI::App* command = app.add_subcommand(
      "excite", "Design a trajectory for identifying an arm's dynamics, and simulate its logs");
  ExciteSettings& settings = args->settings;
  ExcitationOptions& d = settings.design;
  command->add_option("ROBOT", args->robot, "bundled robot, robot YAML or URDF")->required();
  command->add_option("--out", settings.folder, "new folder for excitation.yaml, trajectory.csv and logs")
      ->required();
  add_motion_options(*command, *args);
  command
      ->add_option("--evaluations", d.evaluations, "largest number of trajectories that the design evaluates")
      ->check(CLI::Range(1, 100000000))
      ->capture_default_str();
  command->add_option("--seed", d.seed, "seed of the random trajectories from which the design starts")
      ->capture_default_str();
  command
      ->add_option("--trajectory", settings.trajectory,
                   "use the trajectory of this excitation.yaml instead of designing one")
      ->check(readable_file());
  command->add_option("--scenario", args->scenarios,
                      "also simulate the trajectory with this scenario's arm, and write a log; the arm "
                      "carries no payload unless --payload is given");
  command
      ->add_option("--torque-noise", settings.log.torque_noise,
                   "standard deviation of the noise that is added to the logged torques [N m, N]")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command->add_flag("--payload", settings.log.payload, "let the simulated tool carry the scenario's payload");
  command->footer(
      "The motion keeps the arm from touching itself and the cell of its robot file, as far as the\n"
      "shapes of the links are known. The output says what was checked. Obstacles and cells of scenarios\n"
      "are never checked. Look at trajectory.csv, and run the trajectory slowly first.\n\n"
      "Example:\n  armtune excite ur10 --center 0,-90,-60,-90,90,0 --min-height 0.1 --out runs/excite "
      "--scenario moving_target\n"
      "  armtune identify runs/excite/log_moving_target.csv --robot ur10 --out runs/identified\n");
  command->callback([args, &exit_code] { exit_code = run_excite(*args); });
}

}  // namespace armtune::internal::cli
