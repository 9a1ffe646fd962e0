// armtune identify: an arm's parameters from logs of its motion.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>

#include "core/common/error.hpp"
#include "core/robot/urdf_writer.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/identify_report.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/progress_line.hpp"
#include "tuner/cli/readable_file.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/identification/identification_files.hpp"
#include "tuner/identification/theta_doubts.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune::cli {
namespace {

struct Arguments {
  std::vector<std::string> logs;
  std::string robot = "ur10";
  std::string columns;
  std::string folder;
  bool accept = false;
  IdentifyOptions options;
};

/// Why the logs may not be of this arm: the likely mistake alone, as everything else follows from it, or what
/// is odd about the result.
std::vector<std::string> find_doubts(const RobotModel& model, const Identification& found) {
  if (found.comparison.mistake) return {to_text(*found.comparison.mistake, model)};
  return theta_doubts(model, found);
}

void write_files(const Arguments& args, const RobotModel& model, const Identification& found,
                 const std::vector<std::string>& doubts, double seconds) {
  const std::string& folder = args.folder;
  const RobotModel identified = with_theta(model, found.theta);
  std::vector<std::string> header = {
      fmt::format("theta of {}, identified by armtune from {} samples", model.name, found.samples),
      "a scenario's controller starts from it with `theta_start: {file: theta.yaml}`"};
  for (const std::string& doubt : doubts) header.push_back("ACCEPTED ALTHOUGH " + doubt);
  write_text_file(folder + "/theta.yaml", theta_yaml(model, found.theta, header));
  write_text_file(folder + "/base_parameters.csv", base_parameters_csv(model, found));
  write_text_file(folder + "/robot.urdf", urdf_text(identified));
  write_text_file(folder + "/robot.yaml", robot_yaml(identified, "robot.urdf"));
  Provenance p;
  p.command = command_line();
  for (std::size_t i = 0; i < args.logs.size(); ++i)
    p.streamed.emplace_back(args.logs[i], found.log_hashes[i]);
  p.inputs.push_back(model.source);
  if (!args.columns.empty()) p.inputs.push_back(args.columns);
  p.wall_seconds = seconds;
  p.extra = {{"samples", fmt::format("{}", found.samples)},
             {"base_parameters", fmt::format("{}", found.base.rank())},
             {"condition_number", fmt::format("{:.6g}", found.estimate.condition)},
             {"made_physical", found.made_physical ? "yes" : "no"}};
  const auto add = [&](const char* key, const Eigen::VectorXd& values) {
    for (int j = 0; j < model.n(); ++j) {
      p.extra.emplace_back(fmt::format("{}/{}", key, model.joints[static_cast<std::size_t>(j)].name),
                           fmt::format("{:.6g}", values[j]));
    }
  };
  add("torque_rms", found.fitted.torque);
  add("torque_not_explained/fitted", found.fitted.by_theta);
  if (found.held_out.rows > 0) add("torque_not_explained/held_out", found.held_out.by_theta);
  add("torque_not_explained/robot_file", found.fitted.by_file);
  if (!doubts.empty()) p.extra.emplace_back("accepted_although", fmt::format("{}", fmt::join(doubts, "; ")));
  write_provenance(folder, p);
}

/// The folder is made before the logs, which can take minutes, are read.
void remove_if_empty(const std::string& folder) {
  std::error_code ignored;
  if (!folder.empty()) std::filesystem::remove(folder, ignored);
}

int run(const Arguments& args) {
  const auto model = load_robot(args.robot);
  const LogColumns columns =
      args.columns.empty() ? default_log_columns(*model) : load_log_columns(args.columns, *model);
  const FolderLock lock = make_run_folder(args.folder);
  ProgressLine line;
  IdentifyOptions options = args.options;
  long shown = -1;
  options.progress = [&](int pass, std::size_t log, long samples) {
    if (samples / 20000 == shown) return;
    shown = samples / 20000;
    line.show(fmt::format("pass {}, log {} of {}, {} samples", pass + 1, log + 1, args.logs.size(), samples));
  };
  const auto began = std::chrono::steady_clock::now();
  const Identification found = [&] {
    try {
      return identify(*model, args.logs, columns, options, stop_requested());
    } catch (const InputError&) {
      remove_if_empty(args.folder);
      throw;
    }
  }();
  line.clear();
  if (found.interrupted) return kInterrupted;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - began;
  const std::vector<std::string> doubts = find_doubts(*model, found);
  const bool doubtful = !doubts.empty();
  const bool written = !args.folder.empty() && (!doubtful || args.accept);
  // Results come first: standard output may be a full disk.
  if (written) {
    write_files(args, *model, found, doubts, elapsed.count());
  } else {
    remove_if_empty(args.folder);
  }
  print_identification(*model, found);
  if (written) {
    say(fmt::format("wrote {}: theta.yaml, base_parameters.csv, robot.urdf, robot.yaml, run.yaml\n",
                    args.folder));
  }
  if (doubtful) {
    say("\nThe logs do not fit the robot file:\n");
    for (const std::string& doubt : doubts) say(fmt::format("  {}.\n", doubt));
    if (!written) say("Nothing was written. If the logs are right all the same, add --accept.\n");
  }
  return doubtful ? kChecksFailed : kDone;
}

}  // namespace

void add_identify_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "identify",
      "Find an arm's inertial and friction parameters from logs of positions, velocities and torques");
  command
      ->add_option("LOG", args->logs,
                   "CSV files: time, joint/NAME/position, joint/NAME/torque, if there joint/NAME/velocity "
                   "(checked against the "
                   "positions); as simulate and excite write them")
      ->required()
      ->check(readable_file());
  command
      ->add_option("--robot", args->robot,
                   "bundled robot, robot YAML or URDF: geometry, names and prior values")
      ->capture_default_str();
  command->add_option("--out", args->folder,
                      "new folder for theta.yaml, base_parameters.csv, robot.urdf and the rest");
  command->add_option("--columns", args->columns,
                      "YAML that says which columns of the logs hold what, with units' factors");
  command
      ->add_option("--cutoff", args->options.rows.cutoff,
                   "of the zero-phase filter [Hz]: five times the highest frequency that moves the arm; "
                   "lower lets less "
                   "noise through, higher keeps friction's edges")
      ->check(CLI::Range(0.1, 1000.0))
      ->capture_default_str();
  command
      ->add_option(
          "--torque-delay", args->options.rows.torque_delay,
          "the logged torque acts so much later [s]; a torque held from its row on: half a control period")
      ->capture_default_str();
  command->add_flag("--robust", args->options.robust,
                    "give outliers less weight (Huber), in several passes over the logs");
  command->add_flag(
      "!--fit-all", args->options.hold_out,
      "fit to all of the logs; without it every fifth second is left out, to check the result on it");
  command->add_flag(
      "--accept", args->accept,
      "write the result although the logs do not fit the robot file (exit code 3 all the same)");
  command->footer(
      "Record a motion that moves every joint through its range at several speeds (armtune excite designs "
      "one), then:\n"
      "  armtune identify log.csv --robot my_arm.yaml --out runs/identified\n"
      "A scenario starts from the result with  theta_start: {file: runs/identified/theta.yaml}\n"
      "Column map:  time: t\n             position: {columns: [q1, q2], scale: 0.0174533}\n"
      "             torque: {columns: [tau1, tau2], scale: [10.0, 8.5]}\n"
      "Cells may be separated by commas, semicolons, tabs or blanks.\n");
  command->callback([args, &exit_code] { exit_code = run(*args); });
}

}  // namespace armtune::cli
