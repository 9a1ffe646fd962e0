#include "sim/scenario/scenario.hpp"

#include <cmath>

#include "core/robot/theta.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune {

int Scenario::periods() const {
  return static_cast<int>(std::llround(duration / control_period));
}

std::size_t Scenario::active_target(double t) const {
  if (switch_every <= 0.0 || targets.size() < 2) return 0;
  // Half a period's grace, so that rounding of k * dt does not decide on which side of a switch t lies.
  const auto turns = static_cast<std::size_t>((t + 0.5 * control_period) / switch_every);
  return turns % targets.size();
}

RobotModel plant_model(const Scenario& scenario) {
  RobotModel plant = with_payload(*scenario.robot, scenario.plant.payload);
  if (scenario.plant.viscous_friction.size() > 0) {
    plant.chain.viscous_friction += scenario.plant.viscous_friction;
  }
  if (scenario.plant.coulomb_friction.size() > 0) {
    plant.chain.coulomb_friction += scenario.plant.coulomb_friction;
  }
  return plant;
}

ParameterVector start_theta(const Scenario& scenario) {
  if (scenario.theta.file.empty()) return scenario.theta.model_scale * theta_of(scenario.robot->chain);
  const yaml::Node root = yaml::parse_file(scenario.theta.file);
  yaml::MapReader map(root);
  const auto names = theta_names(*scenario.robot);
  ParameterVector theta(static_cast<Eigen::Index>(names.size()));
  Eigen::Index i = 0;
  for (const std::string& entry : names) theta[i++] = map.number(entry);
  map.finish();
  return theta;
}

void start_theta_from(const std::string& file, Scenario& scenario) {
  scenario.theta = {0.0, file};
  start_theta(scenario);  // a mistake in it shows now rather than in the first rollout
  scenario.inputs.push_back(file);
}

}  // namespace armtune
