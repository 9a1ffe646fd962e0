#include "tuner/robustness/drawn_arm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/robot/urdf_writer.hpp"
#include "sim/scenario/arm_distribution.hpp"
#include "sim/scenario/robot_writer.hpp"

namespace armtune::internal {
namespace {

constexpr std::array kOfJoint = {"mass_factor",      "inertia_factor",   "rotor_factor",
                                 "center_x",         "center_y",         "center_z",
                                 "viscous_friction", "coulomb_friction", "theta_factor"};
constexpr std::array kOfArm = {"payload", "delay", "position_noise", "velocity_noise"};

double entry(const JointVector& values, Eigen::Index i, double otherwise) {
  return values.size() > 0 ? values[i] : otherwise;
}

/// Returns the values of joint i, in the order of kOfJoint.
std::array<double, kOfJoint.size()> of_joint(const Scenario& drawn, Eigen::Index i) {
  const PlantConditions& plant = drawn.plant;
  const auto center = [&](Eigen::Index axis) {
    return plant.center_offsets.cols() > 0 ? plant.center_offsets(axis, i) : 0.0;
  };
  return {entry(plant.mass_factors, i, 1.0),
          entry(plant.inertia_factors, i, 1.0),
          entry(plant.rotor_factors, i, 1.0),
          center(0),
          center(1),
          center(2),
          entry(plant.viscous_friction, i, 0.0),
          entry(plant.coulomb_friction, i, 0.0),
          entry(drawn.theta.factors, i, 1.0)};
}

/// Returns the names and paths of the targets and obstacles of a scenario.
std::vector<std::pair<std::string, const Path*>> moving(const Scenario& scenario) {
  std::vector<std::pair<std::string, const Path*>> paths;
  for (const NamedPath& target : scenario.targets) paths.emplace_back(target.name, &target.path);
  for (const MovingObstacle& obstacle : scenario.obstacles) paths.emplace_back(obstacle.name, &obstacle.path);
  return paths;
}

std::vector<std::string> names_of_moving(const std::vector<Scenario>& scenarios) {
  std::vector<std::string> names;
  for (const Scenario& scenario : scenarios) {
    for (const auto& [name, path] : moving(scenario)) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

double rate(const Path& path) {
  return path.spline ? path.spline_rate : path.frequency;
}

}  // namespace

std::vector<std::string> distribution_columns(const Perturbation& perturbation) {
  std::vector<std::string> columns;
  if (!perturbation.distribution) return columns;
  for (const ArmParameter& p : perturbation.distribution->parameters) {
    if (p.is_drawn()) columns.push_back("distribution/" + p.name);
  }
  return columns;
}

std::vector<double> distribution_values(const Perturbation& perturbation, std::uint64_t seed,
                                        std::uint64_t sample) {
  std::vector<double> values;
  if (!perturbation.distribution) return values;
  const Eigen::VectorXd drawn = drawn_parameters(*perturbation.distribution, seed, sample);
  Eigen::Index i = 0;
  for (const ArmParameter& p : perturbation.distribution->parameters) {
    const double value = drawn[i++];
    if (p.is_drawn()) values.push_back(value);
  }
  return values;
}

std::vector<std::string> drawn_columns(const std::vector<Scenario>& scenarios) {
  std::vector<std::string> columns;
  for (const std::string& joint : joint_names(*scenarios.front().robot)) {
    for (const char* what : kOfJoint) columns.push_back(fmt::format("drawn/{}/{}", joint, what));
  }
  for (const char* what : kOfArm) columns.push_back(fmt::format("drawn/{}", what));
  for (const std::string& name : names_of_moving(scenarios)) {
    columns.push_back(fmt::format("drawn/{}/speed_factor", name));
    columns.push_back(fmt::format("drawn/{}/phase", name));
  }
  return columns;
}

std::vector<double> drawn_values(const std::vector<Scenario>& scenarios, const Scenario& scenario,
                                 const Scenario& drawn) {
  std::vector<double> values;
  for (Eigen::Index i = 0; i < drawn.robot->n(); ++i) {
    for (const double value : of_joint(drawn, i)) values.push_back(value);
  }
  for (const double value : {drawn.plant.payload.mass, double(drawn.plant.torque_delay_periods),
                             drawn.plant.position_noise, drawn.plant.velocity_noise})
    values.push_back(value);
  const auto own = moving(scenario);
  const auto now = moving(drawn);
  for (const std::string& name : names_of_moving(scenarios)) {
    const auto found =
        std::find_if(own.begin(), own.end(), [&name](const auto& path) { return path.first == name; });
    if (found == own.end()) {
      values.insert(values.end(), 2, NAN);
      continue;
    }
    const Path& path = *now[static_cast<std::size_t>(found - own.begin())].second;
    values.push_back(rate(*found->second) == 0.0 ? 1.0 : rate(path) / rate(*found->second));
    values.push_back(path.phase);
  }
  return values;
}

std::vector<std::pair<std::string, std::string>> drawn_arm_files(const Scenario& drawn) {
  const RobotModel arm = plant_model(drawn);
  std::string comment =
      fmt::format("The arm that was simulated in {}, with its payload and friction", drawn.name);
  if (drawn.plant.arm) comment += ". Delay, tilt of the base and encoder offsets are not included";
  if (drawn.clearance)
    comment +=
        ". The 'cell' around the arm is not included; add a cell to the robot or the scenario to check "
        "contacts";
  return {{"arm.urdf", urdf_text(arm)}, {"arm.yaml", robot_yaml(arm, "arm.urdf", comment)}};
}

}  // namespace armtune::internal
