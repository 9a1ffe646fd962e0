// The command `armtune validate`, which says whether a robot file predicts what a robot recorded.

#include <CLI/CLI.hpp>
#include <memory>

#include "sim/controller_files/parameter_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/gain_set.hpp"
#include "tuner/cli/log_options.hpp"
#include "tuner/cli/resume.hpp"
#include "tuner/cli/session_printer.hpp"
#include "tuner/cli/validate_printer.hpp"
#include "tuner/controller_study/controller_rate.hpp"

namespace armtune::internal::cli {
namespace {

struct ValidateArguments {
  std::string robot, columns, commands, gains, controllers, node;
  LogArguments log;
  ValidateSettings settings = {};
};

/// Reads the controller whose reference the log has, if one is named.
void read_controller_of_log(const ValidateArguments& args, ValidateSettings& settings) {
  LoggedJointsOptions& options = settings.options;
  const std::vector<std::string> joints = joint_names(*settings.model);
  if (!args.controllers.empty()) {
    const ParameterFile file = required_parameter_file(args.controllers, args.node, {}, joints);
    options.gains = load_gains(args.controllers, joints, args.node);
    if (const auto rate = controller_rate(file.controller, file.path))
      options.control_period = 1.0 / rate->hertz;
    settings.files = files_of_gains(args.controllers);
  } else if (!args.gains.empty()) {
    const std::string path = find_data_file("gains", gains_name(args.gains));
    options.gains = load_gains(path, joints);
    settings.files = files_of_gains(path);
  }
}

int run_validate(const ValidateArguments& args) {
  ValidateSettings settings = args.settings;
  settings.model = load_robot(args.robot);
  settings.options.selection = selection_of(args.log);
  read_controller_of_log(args, settings);
  if (!args.columns.empty()) {
    settings.options.columns = load_log_columns(args.columns, *settings.model);
    settings.files.push_back(args.columns);
  }
  settings.options.commands = args.commands != "none";
  for (const CommandKind kind : {CommandKind::kTorque, CommandKind::kVelocity, CommandKind::kPosition}) {
    if (args.commands == name(kind)) settings.options.command = kind;
  }
  SessionPrinter<> printer;
  const ValidateOutcome outcome = ValidateSession(settings, session_context(), printer).run();
  if (outcome.ending != Ending::kInterrupted) print_validation(settings, outcome);
  return static_cast<int>(outcome.ending);
}

}  // namespace

void add_validate_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<ValidateArguments>();
  CLI::App* command = app.add_subcommand(
      "validate", "Say whether a robot file predicts a recording of the robot and, if not, what it lacks");
  command
      ->add_option("LOG", args->settings.logs,
                   "CSV file in any common layout, .mcap file, .db3 file, or folder of rosbag2. Several text "
                   "files are read side by side as one log")
      ->required();
  command->add_option("--robot", args->robot, "bundled robot, robot YAML or URDF, used as it is")->required();
  command
      ->add_option("--out", args->settings.folder,
                   "new folder for report.html, residuals.csv, horizons.csv and run.json")
      ->default_str("no files");
  command->add_option(
      "--columns", args->columns,
      "YAML file (column map) that names the channel of each joint, with factors to SI units; "
      "needed for motor currents");
  command
      ->add_option("--commands", args->commands,
                   "commands in the log with which the motion is simulated. 'torque' takes measured torques "
                   "where there are no others")
      ->check(CLI::IsMember({"position", "velocity", "torque", "none"}))
      ->default_str("the first kind that the log has");
  CLI::Option* controllers =
      command->add_option("--controllers", args->controllers,
                          "ROS parameter file of the controller that followed the logged reference; it is "
                          "simulated with the robot file");
  command->add_option("--node", args->node, "name of the controller, if the file has several")
      ->needs(controllers);
  command
      ->add_option(
          "--gains", args->gains,
          "gains file, bundled gains or run folder of the controller that followed the logged reference; in "
          "place of --controllers")
      ->excludes(controllers);
  add_log_options(*command, args->log);
  command->footer(
      "Three things are compared, as far as the log allows:\n"
      "  torques  measured ones with those that the robot file predicts for the logged motion\n"
      "  motion   the arm is simulated ahead from logged states, under the logged commands\n"
      "  the log  units, signs, order of joints, time offsets, clipping, gaps, mounting\n"
      "Nothing is fitted. Each misfit comes with its likely cause and size, such as missing friction. The\n"
      "thresholds of the verdict are printed. Exit code 3: the robot file does not predict the log.\n"
      "Record every joint in motion, with reversals, for half a minute. 'armtune logs FILE' shows what a\n"
      "log holds. docs/validation.md explains the figures.\n\n"
      "Examples:\n"
      "  armtune validate recording.mcap --robot ur10 --topic /joint_states --out runs/validated\n"
      "  armtune validate run.csv --robot my_arm.yaml --columns map.yaml\n"
      "  armtune validate bag/ --robot panda --controllers ros2_controllers.yaml\n");
  command->callback([args, &exit_code] { exit_code = run_validate(*args); });
}

}  // namespace armtune::internal::cli
