// armtune identify: an arm's parameters from logs of its motion.

#include <fmt/format.h>

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
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/progress_line.hpp"
#include "tuner/identification/identification_files.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune::cli {
namespace {

struct Arguments {
  std::vector<std::string> logs;
  std::string robot = "ur10";
  std::string columns;
  std::string folder;
  IdentifyOptions options;
};

constexpr double kUncertain = 0.3;  ///< relative standard deviation from which a group is called uncertain

void show(const RobotModel& model, const Identification& found) {
  const Eigen::VectorXd file = found.base.map * theta_of(model.chain);
  const Eigen::VectorXd deviation = found.estimate.deviation();
  fmt::print("{:<58}{:>12}{:>12}{:>12}\n", "base parameter (group of inertial parameters)", "estimate", "+-",
             "robot file");
  for (Eigen::Index b = 0; b < file.size(); ++b) {
    std::string name = found.base.names[static_cast<std::size_t>(b)];
    if (name.size() > 56) name = name.substr(0, 53) + "...";
    fmt::print("{:<58}{:>12.5g}{:>12.2g}{:>12.5g}\n", name, found.estimate.theta[b], deviation[b], file[b]);
  }
  fmt::print("\n{:<28}{:>16}{:>18}{:>10}\n", "joint", "torque RMS", "not explained", "share");
  for (int j = 0; j < model.n(); ++j) {
    fmt::print("{:<28}{:>16.4g}{:>18.4g}{:>9.2f}%\n", model.joints[static_cast<std::size_t>(j)].name,
               found.torque_rms[j], found.estimate.torque_residual[j],
               100.0 * found.estimate.torque_residual[j] / found.torque_rms[j]);
  }
  fmt::print("\n{} samples, {} rows, {} base parameters of {}, condition number {:.4g}\n", found.samples,
             found.estimate.rows * model.n(), found.base.rank(), found.theta.size(),
             found.estimate.condition);
  if (found.made_physical) {
    fmt::print("theta was moved to the nearest one that a physical arm can have.\n");
  }
  for (const int b : found.estimate.not_excited) {
    fmt::print("not excited by these logs, kept at the robot file's value: {}\n",
               found.base.names[static_cast<std::size_t>(b)]);
  }
  const auto uncertain = std::count_if(file.begin(), file.end(), [&, b = Eigen::Index{0}](double) mutable {
    const Eigen::Index k = b++;
    return deviation[k] > kUncertain * std::abs(found.estimate.theta[k]);
  });
  if (uncertain > 0) {
    fmt::print("{} groups are known to worse than {:.0f} %: small ones, or the motion says little of them.\n",
               uncertain, 100.0 * kUncertain);
  }
}

void write_files(const Arguments& args, const RobotModel& model, const Identification& found,
                 double seconds) {
  const std::string& folder = args.folder;
  const RobotModel identified = with_theta(model, found.theta);
  write_text_file(
      folder + "/theta.yaml",
      theta_yaml(
          model, found.theta,
          {fmt::format("theta of {}, identified by armtune from {} samples", model.name, found.samples),
           "a scenario's controller starts from it with `theta_start: {file: theta.yaml}`"}));
  write_text_file(folder + "/base_parameters.csv", base_parameters_csv(model, found));
  write_text_file(folder + "/robot.urdf", urdf_text(identified));
  write_text_file(folder + "/robot.yaml", robot_yaml(identified, "robot.urdf"));
  Provenance p;
  p.command = command_line();
  p.inputs = args.logs;
  p.inputs.push_back(model.source);
  if (!args.columns.empty()) p.inputs.push_back(args.columns);
  p.wall_seconds = seconds;
  p.extra = {{"samples", fmt::format("{}", found.samples)},
             {"base_parameters", fmt::format("{}", found.base.rank())},
             {"condition_number", fmt::format("{:.6g}", found.estimate.condition)},
             {"made_physical", found.made_physical ? "yes" : "no"}};
  for (int j = 0; j < model.n(); ++j) {
    p.extra.emplace_back("torque_not_explained/" + model.joints[static_cast<std::size_t>(j)].name,
                         fmt::format("{:.6g}", found.estimate.torque_residual[j]));
  }
  write_text_file(folder + "/run.yaml", run_yaml(p));
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
      // Made before the logs, which can take minutes, are read; removed while it is empty.
      std::error_code ignored;
      if (!args.folder.empty()) std::filesystem::remove(args.folder, ignored);
      throw;
    }
  }();
  line.clear();
  if (found.interrupted) return kInterrupted;
  show(*model, found);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - began;
  if (!args.folder.empty()) {
    write_files(args, *model, found, elapsed.count());
    fmt::print("wrote {}: theta.yaml, base_parameters.csv, robot.urdf, robot.yaml, run.yaml\n", args.folder);
  }
  return kDone;
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
      ->check(CLI::ExistingFile);
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
                    "weigh outliers down (Huber), in several passes over the logs");
  command->footer(
      "Record a motion that moves every joint through its range at several speeds (armtune excite designs "
      "one), then:\n"
      "  armtune identify log.csv --robot my_arm.yaml --out runs/identified\n"
      "A scenario starts from the result with  theta_start: {file: runs/identified/theta.yaml}\n"
      "Column map:  time: t\n             position: {columns: [q1, q2], scale: 0.0174533}\n"
      "             torque: {columns: [tau1, tau2]}\n");
  command->callback([args, &exit_code] { exit_code = run(*args); });
}

}  // namespace armtune::cli
