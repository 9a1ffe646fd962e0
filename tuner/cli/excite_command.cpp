// armtune excite: a trajectory that shows an arm's parameters, and simulated logs of it.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>

#include "armtune/error.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/excite_printer.hpp"
#include "tuner/cli/readable_file.hpp"
#include "tuner/cli/resume.hpp"

namespace armtune::internal::cli {
namespace {

struct Arguments {
  std::string robot;
  std::vector<double> center_deg;
  std::vector<std::string> scenarios;
  double fade = NAN;
  ExciteSettings settings = {};
};

JointVector center_in_si(const RobotModel& model, const std::vector<double>& degrees) {
  if (degrees.empty()) return {};
  if (static_cast<int>(degrees.size()) != model.n()) {
    throw InputError(
        fmt::format("--center has {} values, but {} has {} joints; give one value for each joint: {}",
                    degrees.size(), model.name, model.n(), fmt::join(joint_names(model), " ")));
  }
  return in_si(model, Eigen::Map<const Eigen::VectorXd>(degrees.data(), model.n()));
}

ExciteSettings settings_of(const Arguments& args) {
  ExciteSettings settings = args.settings;
  settings.model = load_robot(args.robot);
  for (const std::string& name : args.scenarios) {
    const RobotModel& robot = *settings.scenarios.emplace_back(load_scenario(name)).robot;
    if (robot.name == settings.model->name && joint_names(robot) != joint_names(*settings.model)) {
      throw InputError(fmt::format(
          "{}: the scenario's robot has the same name as ROBOT, {}, but other joints; give the robot "
          "file of the scenario as ROBOT",
          name, robot.name));
    }
    if (robot.name != settings.model->name) {
      throw InputError(
          fmt::format("{}: the scenario's robot is {}, but ROBOT is {}; give the same robot as "
                      "ROBOT, or a scenario with {}",
                      name, robot.name, settings.model->name, settings.model->name));
    }
  }
  ExcitationOptions& design = settings.design;
  design.center = center_in_si(*settings.model, args.center_deg);
  design.fade = std::isnan(args.fade) ? std::min(design.fade, 0.25 * design.duration) : args.fade;
  return settings;
}

int run(const Arguments& args) {
  const ExciteSettings settings = settings_of(args);
  ExcitePrinter printer;
  const ExciteOutcome outcome = ExciteSession(settings, session_context(), printer).run();
  printer.ended(settings, outcome);
  return static_cast<int>(outcome.ending);
}

/// Adds the options that shape the motion.
void add_motion_options(CLI::App& command, Arguments& args) {
  ExcitationOptions& d = args.settings.design;
  command
      .add_option("--center", args.center_deg,
                  "joint positions around which the arm moves [deg; m for prismatic joints] (default: the "
                  "middle of the position limits)")
      ->delimiter(',');
  command
      .add_option("--amplitude", d.amplitude,
                  "largest distance of a joint from its --center position [rad, m]")
      ->check(CLI::Range(1e-3, 10.0))
      ->capture_default_str();
  command.add_option("--margin", d.margin, "share of the velocity and effort limits that the motion may use")
      ->check(CLI::Range(0.01, 1.0))
      ->capture_default_str();
  command.add_option(
      "--min-height", d.min_height,
      "lowest allowed z of the tool and of the joint origins, in the base frame [m]; the origins of the "
      "first two joints are exempt (default: no limit)");
  command.add_option("--frequency", d.frequency, "base frequency of the motion's Fourier series [Hz]")
      ->check(CLI::Range(1e-3, 10.0))
      ->capture_default_str();
  command.add_option("--harmonics", d.harmonics, "number of harmonics in the motion's Fourier series")
      ->check(CLI::Range(1, 50))
      ->capture_default_str();
  command.add_option("--duration", d.duration, "duration of the trajectory [s]")
      ->check(CLI::Range(1.0, kLongestExcitation))
      ->capture_default_str();
  command
      .add_option("--fade", args.fade,
                  "time in which the motion builds up at the start and dies down at the end [s] (default: 2, "
                  "or a quarter of the trajectory's duration if that is less)")
      ->check(CLI::Range(0.1, 10.0));
}

}  // namespace

void add_excite_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<Arguments>();
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
  command->add_flag("--payload", settings.log.payload,
                    "simulate the logs with the scenario's payload at the tool");
  command->footer(
      "Collisions of the arm with itself or its surroundings are not checked. Check trajectory.csv, and run\n"
      "the trajectory slowly first.\n\n"
      "Example:\n  armtune excite ur10 --center 0,-90,-60,-90,90,0 --min-height 0.1 --out runs/excite "
      "--scenario moving_target\n"
      "  armtune identify runs/excite/log_moving_target.csv --robot ur10 --out runs/identified\n");
  command->callback([args, &exit_code] { exit_code = run(*args); });
}

}  // namespace armtune::internal::cli
