#include "tuner/robustness/margin_kind.hpp"

namespace armtune::internal {
namespace {

/// Ratio of position noise to velocity noise, used if the scenario has no velocity noise [rad per rad/s]. It
/// is the ratio of the realistic scenarios, 1e-4 rad to 0.01 rad/s.
constexpr double kNoiseRatio = 1e-2;

double rate(const Scenario& scenario) {
  return 1.0 / scenario.control_period;
}

void set_rate(double value, Scenario& scenario, Gains&) {
  if (value != rate(scenario)) scenario.control_period = 1.0 / value;
}

double velocity_noise(const Scenario& scenario) {
  return scenario.plant.velocity_noise;
}

void set_noise(double value, Scenario& scenario, Gains&) {
  PlantConditions& plant = scenario.plant;
  if (value == plant.velocity_noise) return;
  const double ratio = plant.velocity_noise > 0.0 ? plant.position_noise / plant.velocity_noise : kNoiseRatio;
  plant.velocity_noise = value;
  plant.position_noise = ratio * value;
}

void delay_more(double value, Scenario& scenario, Gains&) {
  scenario.plant.torque_delay_periods += static_cast<int>(value);
}

void scale_gains(double value, Scenario& scenario, Gains&) {
  scenario.loop_gain *= value;
}

}  // namespace

const std::array<MarginField, kMarginCount>& margin_fields() {
  // The strides are small enough to meet the first failure, and not to step over it to stable values beyond.
  // Noise has larger strides, because its search has the longest way to go.
  static const std::array<MarginField, kMarginCount> fields{{
      {"torque_delay", "periods",
       "largest additional delay, in control periods, of torques or of commands to the robot's drives",
       [](const Scenario&) { return 0.0; }, delay_more,
       EdgeSearch{.first = 1.0, .stride = 2.0, .last = 1000.0, .whole = true}},
      {"gain_factor", "1",
       "largest factor by which task_space_gains_p, task_space_gains_d and the controller's own gains can all "
       "be multiplied",
       [](const Scenario&) { return 1.0; }, scale_gains, EdgeSearch{.stride = 1.25, .last = 100.0}},
      {"control_rate", "Hz", "lowest control rate; the torque delay stays the same number of control periods",
       rate, set_rate, EdgeSearch{.stride = 0.8, .last = 10.0}},
      {"velocity_noise", "rad/s",
       "largest standard deviation of the velocity noise; the position noise is scaled by the same factor. "
       "If the scenario has no velocity noise, the position noise is 0.01 rad for each rad/s",
       velocity_noise, set_noise, EdgeSearch{.first = 0.01, .stride = 1.5, .last = 10.0}},
  }};
  return fields;
}

}  // namespace armtune::internal
