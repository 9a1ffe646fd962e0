// The command `armtune identify`, which finds an arm's dynamic parameters from logs of its motion.

#include <CLI/CLI.hpp>
#include <memory>

#include "sim/scenario/robot_file.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/identify_report.hpp"
#include "tuner/cli/readable_file.hpp"
#include "tuner/cli/resume.hpp"
#include "tuner/cli/session_printer.hpp"

namespace armtune::internal::cli {
namespace {

struct IdentifyArguments {
  std::string robot;
  IdentifySettings settings = {};
};

int run_identify(const IdentifyArguments& args) {
  IdentifySettings settings = args.settings;
  settings.model = load_robot(args.robot);
  const std::string& columns = settings.columns_path;
  settings.columns =
      columns.empty() ? default_log_columns(*settings.model) : load_log_columns(columns, *settings.model);
  SessionPrinter<> printer;
  const IdentifyOutcome outcome = IdentifySession(settings, session_context(), printer).run();
  if (outcome.ending != Ending::kInterrupted) print_identification(settings, outcome);
  return static_cast<int>(outcome.ending);
}

}  // namespace

void add_identify_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<IdentifyArguments>();
  IdentifySettings& settings = args->settings;
  CLI::App* command = app.add_subcommand(
      "identify",
      "Find an arm's inertial and friction parameters from logs of positions, velocities and torques");
  command
      ->add_option("LOG", settings.logs,
                   "CSV files with the columns time, joint/NAME/position and joint/NAME/torque, as simulate "
                   "and excite write them. joint/NAME/velocity is optional and only compared with the "
                   "positions")
      ->required()
      ->check(readable_file());
  command
      ->add_option("--robot", args->robot,
                   "bundled robot, robot YAML or URDF; it gives the geometry, the joint names and the prior "
                   "values of the parameters")
      ->required();
  command
      ->add_option("--out", settings.folder,
                   "new folder for theta.yaml, base_parameters.csv, robot.urdf and other results")
      ->default_str("no files");
  command->add_option("--columns", settings.columns_path,
                      "YAML file (column map) with the log column of each quantity, and with the factors "
                      "that convert other units to SI units");
  command
      ->add_option("--cutoff", settings.options.rows.cutoff,
                   "cutoff frequency of the zero-phase filter [Hz]. Use about five times the highest "
                   "frequency of the motion. A lower value removes more noise. A higher value keeps more of "
                   "the jumps of friction when a joint reverses")
      ->check(CLI::Range(0.1, 1000.0))
      ->capture_default_str();
  command
      ->add_option(
          "--torque-delay", settings.options.rows.torque_delay,
          "delay of the logged torque [s]. Give half a control period if the torque of a row is held until "
          "the next row")
      ->capture_default_str();
  command->add_flag("--robust", settings.options.robust,
                    "give outliers less weight (Huber), in several passes over the logs");
  command->add_flag(
      "!--fit-all", settings.options.hold_out,
      "use all samples in the fit. Without this option, one second in five is left out of the fit, and is "
      "used to check the result");
  command->add_flag("--accept", settings.accept,
                    "write the result even if the logs do not fit the robot file; the exit code is still 3");
  command->footer(
      "Record a motion that moves every joint through its range at several speeds (armtune excite designs "
      "one), then:\n"
      "  armtune identify log.csv --robot my_arm.yaml --out runs/identified\n"
      "To start a scenario's controller with the identified parameters, add this line to the scenario:\n"
      "  theta_start: {file: runs/identified/theta.yaml}\n"
      "Example of a column map (--columns):\n"
      "  time: t\n"
      "  position: {columns: [q1, q2], scale: 0.0174533}\n"
      "  torque: {columns: [tau1, tau2], scale: [10.0, 8.5]}\n"
      "In the logs, cells may be separated by commas, semicolons, tabs or blanks.\n");
  command->callback([args, &exit_code] { exit_code = run_identify(*args); });
}

}  // namespace armtune::internal::cli
