#include "tuner/cli/excite_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <utility>

#include "armtune/error.hpp"
#include "sim/cell/clearance_model.hpp"
#include "sim/scenario/robot_file.hpp"

namespace armtune::internal::cli {
namespace {

JointVector center_in_si(const RobotModel& model, const std::vector<double>& degrees) {
  if (degrees.empty()) return {};
  if (static_cast<int>(degrees.size()) != model.n()) {
    throw InputError(
        fmt::format("--center has {} values, but {} has {} joints; give one value for each joint: {}",
                    degrees.size(), model.name, model.n(), fmt::join(joint_names(model), " ")));
  }
  return in_si(model, Eigen::Map<const Eigen::VectorXd>(degrees.data(), model.n()));
}

/// Adds the distances that the motion keeps, unless no distance can be computed or none is required.
void add_distances(const std::string& robot, ExciteSettings& settings) {
  KeptDistances& kept = settings.design.kept;
  if (kept.clearance == 0.0) return;
  const auto cell = cell_of(read_robot_file(robot), settings.cell_files);
  auto model = std::make_shared<const ClearanceModel>(settings.model, cell.value_or(Cell{}));
  if (!model->pairs().empty()) kept.model = std::move(model);
}

}  // namespace

void add_motion_options(CLI::App& command, ExciteArguments& args) {
  ExcitationOptions& d = args.settings.design;
  command
      .add_option("--center", args.center_deg,
                  "joint positions around which the arm moves [deg; m for prismatic joints]")
      ->default_str("the middle of the position limits")
      ->delimiter(',');
  command
      .add_option("--amplitude", d.amplitude,
                  "largest distance of a joint from its --center position [rad, m]")
      ->check(CLI::Range(1e-3, 10.0))
      ->capture_default_str();
  command.add_option("--margin", d.margin, "share of the velocity and effort limits that the motion may use")
      ->check(CLI::Range(0.01, 1.0))
      ->capture_default_str();
  command
      .add_option(
          "--min-height", d.min_height,
          "lowest allowed z of the tool and of the joint origins, in the base frame [m]; the origins of "
          "the first two joints are exempt")
      ->default_str("no limit");
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
                  "time in which the motion builds up at the start and dies down at the end [s]")
      ->default_str("2, or a quarter of the trajectory's duration if that is less")
      ->check(CLI::Range(0.1, 10.0));
  command
      .add_option(
          "--clearance", d.kept.clearance,
          "least distance of the arm from the floor and the parts of the robot file's cell [m]; two "
          "links of the arm keep the smaller one of this distance and 5 mm from each other; 0: not checked")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
}

ExciteSettings settings_of(const ExciteArguments& args) {
  ExciteSettings settings = args.settings;
  settings.model = load_robot(args.robot);
  add_distances(args.robot, settings);
  for (const std::string& name : args.scenarios) {
    const RobotModel& robot = *settings.scenarios.emplace_back(load_scenario(name)).robot;
    if (robot.name == settings.model->name && joint_names(robot) != joint_names(*settings.model)) {
      throw InputError(fmt::format(
          "{}: the scenario's robot and ROBOT are both named {}, but have different joints; give the robot "
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

}  // namespace armtune::internal::cli
