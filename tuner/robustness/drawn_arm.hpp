#pragma once
// What was drawn for an arm at random, as columns of samples.csv and as files.

#include <string>
#include <utility>
#include <vector>

#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// Names of the columns: for each joint of the first scenario's arm drawn/JOINT/mass_factor, inertia_factor,
/// rotor_factor, center_x, center_y, center_z [m], viscous_friction, coulomb_friction and theta_factor;
/// drawn/payload [kg], drawn/delay [control periods], drawn/position_noise [rad, m], drawn/velocity_noise;
/// and for each target and obstacle of any scenario drawn/NAME/speed_factor and drawn/NAME/phase [rad].
std::vector<std::string> drawn_columns(const std::vector<Scenario>& scenarios);

/// Their values for one sample, in their order: as they are in `drawn`, the scenario with the sample's arm.
/// What the scenario does not have is NaN. The scenarios' arms have the same number of joints.
std::vector<double> drawn_values(const std::vector<Scenario>& scenarios, const Scenario& scenario,
                                 const Scenario& drawn);

/// arm.urdf and arm.yaml of the arm that was simulated, payload and friction included: names and texts.
std::vector<std::pair<std::string, std::string>> drawn_arm_files(const Scenario& drawn);

}  // namespace armtune::internal
