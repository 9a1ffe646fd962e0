// armtune excite: a trajectory that shows an arm's parameters, and simulated logs of it.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "core/common/error.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/progress_line.hpp"
#include "tuner/cli/readable_file.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/identification/excitation_design.hpp"
#include "tuner/identification/excitation_log.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune::cli {
namespace {

struct Arguments {
  std::string robot = "ur10";
  std::vector<double> center_deg;
  std::vector<std::string> scenarios;
  std::string trajectory;
  std::string folder;
  double min_height = NAN;
  double fade = NAN;
  ExcitationOptions design;
  ExcitationLogOptions log;
};

JointVector center_in_si(const RobotModel& model, const std::vector<double>& degrees) {
  if (degrees.empty()) return {};
  if (static_cast<int>(degrees.size()) != model.n()) {
    throw InputError(fmt::format("--center has {} values, {} has {} joints: {}", degrees.size(), model.name,
                                 model.n(), fmt::join(joint_names(model), " ")));
  }
  JointVector center(model.n());
  for (int i = 0; i < model.n(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    center[i] = degrees[k] * (model.chain.motion[k] == JointMotion::kRevolute ? M_PI / 180.0 : 1.0);
  }
  return center;
}

/// A trajectory, and what is to be told of it.
struct Told {
  Excitation excitation;
  std::string text;
};

std::string use_text(const ExcitationUse& use) {
  return fmt::format(
      "condition number {:.4g}; largest velocity {:.3g} and effort {:.3g} of their limits, {:.3g} rad or m "
      "from the nearest position limit, lowest point {:.3g} m\n",
      use.condition, use.velocity_ratio, use.effort_ratio, use.position_margin, use.lowest);
}

Told loaded(const Arguments& args, const RobotModel& model) {
  Excitation excitation = load_excitation(args.trajectory, joint_names(model));
  std::string text = use_text(use_of(excitation, model, base_parameters(model)));
  return {std::move(excitation), std::move(text)};
}

Told designed(const Arguments& args, const RobotModel& model) {
  ExcitationOptions options = args.design;
  options.center = center_in_si(model, args.center_deg);
  if (!std::isnan(args.min_height)) options.min_height = args.min_height;
  options.fade = std::isnan(args.fade) ? std::min(options.fade, 0.25 * options.duration) : args.fade;
  ProgressLine line;
  options.progress = [&](long evaluations, double condition) {
    if (evaluations % 200 == 0) {
      line.show(fmt::format("{} of {} evaluations, condition number {:.4g}", evaluations, options.evaluations,
                            condition));
    }
  };
  const ExcitationDesign design = design_excitation(model, options, stop_requested());
  line.clear();
  return {design.excitation,
          fmt::format("{} evaluations; the best of 50 random series has condition number {:.4g}\n",
                      design.evaluations, design.random_condition) +
              use_text(design.use)};
}

int run(const Arguments& args) {
  const auto model = load_robot(args.robot);
  const auto joints = joint_names(*model);
  std::vector<Scenario> scenarios;
  for (const std::string& name : args.scenarios) {
    scenarios.push_back(load_scenario(name));
    if (joint_names(*scenarios.back().robot) != joints) {
      throw InputError(fmt::format("{}: its robot {} is not {}; give --robot", name,
                                   scenarios.back().robot->name, model->name));
    }
  }
  refuse_used_folder(args.folder);  // before the work, not after it
  const auto began = std::chrono::steady_clock::now();
  const Told told = args.trajectory.empty() ? designed(args, *model) : loaded(args, *model);
  const Excitation& excitation = told.excitation;
  const FolderLock lock = make_run_folder(args.folder);
  write_text_file(args.folder + "/excitation.yaml", excitation_yaml(excitation, joints));
  constexpr double kTrajectoryPeriod = 0.002;
  write_text_file(args.folder + "/trajectory.csv", excitation_csv(excitation, joints, kTrajectoryPeriod));
  say(told.text);
  std::string files = "excitation.yaml, trajectory.csv";
  for (const Scenario& scenario : scenarios) {
    if (stop_requested()) break;
    const ExcitationLog log = simulate_excitation(scenario, excitation, args.log, stop_requested());
    if (log.interrupted) break;
    write_text_file(args.folder + "/log_" + scenario.name + ".csv", log_csv(*model, log));
    say(fmt::format(
        "{}: {} samples, the arm stays within {:.3g} rad or m of the trajectory, largest velocity {:.3g} of "
        "its "
        "limit{}\n",
        scenario.name, log.samples.size(), log.tracking_error, log.velocity_ratio,
        log.saturated ? ", torques saturate" : ""));
    files += ", log_" + scenario.name + ".csv";
  }
  Provenance p;
  p.command = command_line();
  p.inputs = {model->source};
  add_inputs(scenarios, p.inputs);
  if (!args.trajectory.empty()) p.inputs.push_back(args.trajectory);
  p.seed = args.design.seed;
  p.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  write_provenance(args.folder, p);
  say(fmt::format("wrote {}: {}, run.yaml\n", args.folder, files));
  return stop_requested() ? kInterrupted : kDone;
}

}  // namespace

void add_excite_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "excite", "Design a trajectory that shows an arm's parameters to identify; simulate logs of it");
  ExcitationOptions& d = args->design;
  command->add_option("ROBOT", args->robot, "bundled robot, robot YAML or URDF")->capture_default_str();
  command->add_option("--out", args->folder, "new folder for excitation.yaml, trajectory.csv and logs")
      ->required();
  command
      ->add_option("--center", args->center_deg,
                   "joint angles to move around [deg] (metres for prismatic joints)")
      ->delimiter(',');
  command->add_option("--amplitude", d.amplitude, "largest distance from the centre [rad, m]")
      ->check(CLI::Range(1e-3, 10.0))
      ->capture_default_str();
  command->add_option("--margin", d.margin, "share of velocity and effort limits that may be used")
      ->check(CLI::Range(0.01, 1.0))
      ->capture_default_str();
  command->add_option(
      "--min-height", args->min_height,
      "origins of the third joint and up, and the tool, stay above this z of the base frame [m]");
  command->add_option("--frequency", d.frequency, "base frequency [Hz]")
      ->check(CLI::Range(1e-3, 10.0))
      ->capture_default_str();
  command->add_option("--harmonics", d.harmonics, "multiples of it")
      ->check(CLI::Range(1, 50))
      ->capture_default_str();
  command->add_option("--duration", d.duration, "[s]")
      ->check(CLI::Range(1.0, kLongestExcitation))
      ->capture_default_str();
  command->add_option("--fade", args->fade, "in and out [s]; 2, or a quarter of a short duration")
      ->check(CLI::Range(0.1, 10.0));
  command->add_option("--evaluations", d.evaluations, "budget of the design")
      ->check(CLI::Range(1, 100000000))
      ->capture_default_str();
  command->add_option("--seed", d.seed, "of the random series it starts from")->capture_default_str();
  command
      ->add_option("--trajectory", args->trajectory, "an excitation.yaml: takes it instead of designing one")
      ->check(readable_file());
  command->add_option("--scenario", args->scenarios,
                      "also simulate this scenario's arm (without its payload) and log it");
  command
      ->add_option("--torque-noise", args->log.torque_noise, "standard deviation of the logged torques [N m]")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command->add_flag("--payload", args->log.payload, "let the scenario's payload hang at the tool");
  command->footer(
      "Nothing here knows where the arm's links, its pedestal or the room are: look at trajectory.csv, and "
      "run it slowly "
      "first.\nExample:\n  armtune excite ur10 --center 0,-90,-60,-90,90,0 --min-height 0.1 --out "
      "runs/excite "
      "--scenario moving_target\n  armtune identify runs/excite/log_moving_target.csv --out "
      "runs/identified\n");
  command->callback([args, &exit_code] { exit_code = run(*args); });
}

}  // namespace armtune::cli
