// The command `armtune calibrate`, which fits what a robot file does not know to recordings of the robot.

#include <CLI/CLI.hpp>
#include <memory>

#include "sim/scenario/robot_file.hpp"
#include "tuner/cli/calibrate_printer.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/log_options.hpp"
#include "tuner/cli/resume.hpp"
#include "tuner/cli/session_printer.hpp"

namespace armtune::internal::cli {
namespace {

struct CalibrateArguments {
  std::string robot, columns, commands;
  LogArguments log;
  CalibrateSettings settings = {};
};

int run_calibrate(const CalibrateArguments& args) {
  CalibrateSettings settings = args.settings;
  settings.model = load_robot(args.robot);
  settings.options.selection = selection_of(args.log);
  if (!args.columns.empty()) {
    settings.options.columns = load_log_columns(args.columns, *settings.model);
    settings.files.push_back(args.columns);
  }
  for (const CommandKind kind : {CommandKind::kTorque, CommandKind::kVelocity, CommandKind::kPosition}) {
    if (args.commands == name(kind)) settings.options.command = kind;
  }
  SessionPrinter<> printer;
  const CalibrateOutcome outcome = CalibrateSession(settings, session_context(), printer).run();
  if (outcome.ending != Ending::kInterrupted) print_calibration(settings, outcome);
  return static_cast<int>(outcome.ending);
}

}  // namespace

void add_calibrate_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<CalibrateArguments>();
  CLI::App* command = app.add_subcommand(
      "calibrate", "Fit friction, rotor inertia, drives, delay and payload of a robot file to recordings");
  command
      ->add_option("LOG", args->settings.logs,
                   "CSV file in any common layout, .mcap file, .db3 file, or folder of rosbag2. Several "
                   "recordings of the same arm, with the same kind of commands, are fitted together")
      ->required();
  command
      ->add_option("--robot", args->robot,
                   "bundled robot, robot YAML or URDF; its values are the most probable ones before the fit")
      ->required();
  command
      ->add_option("--out", args->settings.folder,
                   "new folder for report.html and other results; robot.yaml and uncertainty.yaml only if "
                   "the calibrated arm is better on the held-out part")
      ->default_str("no files");
  command->add_option("--columns", args->columns,
                      "YAML file (column map) that names the channel of each joint, with factors to SI "
                      "units; needed for motor currents");
  command
      ->add_option("--commands", args->commands,
                   "commands in the log that moved the arm. 'torque' takes measured torques where "
                   "there are no others")
      ->check(CLI::IsMember({"position", "velocity", "torque"}))
      ->default_str("the first kind that the log has");
  add_log_options(*command, args->log);
  command->footer(
      "The arm is simulated under the logged commands, and its parameters are changed until its positions\n"
      "are those of the encoders. Measured torques are not needed. Fitted are:\n"
      "  of each joint    viscous and Coulomb friction, rotor inertia, offset of the encoder\n"
      "  of the drives    gains, for velocity and position commands\n"
      "  of the arm       delay of the commands, payload, tilt of the base\n"
      "One part in five of the log is held out. The result is judged by the error of the simulated motion\n"
      "on this part. Exit code 3: the calibrated arm is not better there. Each parameter has a 95 % interval.\n"
      "Those that the log does not tell are named, with the motion that would tell them.\n"
      "Record 20 s or more, with every joint in motion and many reversals. docs/calibration.md explains the\n"
      "method and its limits.\n\n"
      "Examples:\n"
      "  armtune calibrate recording.mcap --robot ur10 --topic /joint_states --out runs/calibrated\n"
      "  armtune calibrate run.csv --robot my_arm.yaml --commands torque\n"
      "  armtune validate other.csv --robot runs/calibrated/robot.yaml\n");
  command->callback([args, &exit_code] { exit_code = run_calibrate(*args); });
}

}  // namespace armtune::internal::cli
