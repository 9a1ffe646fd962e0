#pragma once
// Writes the properties of a randomly drawn arm, on which a Monte Carlo analysis simulates the gains. They
// become columns of samples.csv, and files that describe the arm.

#include <string>
#include <utility>
#include <vector>

#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// Returns the names of the columns. For each joint of the first scenario's arm there are
/// drawn/JOINT/mass_factor, inertia_factor, rotor_factor, center_x, center_y, center_z [m], viscous_friction,
/// coulomb_friction and theta_factor. Then come drawn/payload [kg], drawn/delay [control periods],
/// drawn/position_noise [rad, m] and drawn/velocity_noise. For each target and obstacle of any scenario there
/// are drawn/NAME/speed_factor and drawn/NAME/phase [rad].
std::vector<std::string> drawn_columns(const std::vector<Scenario>& scenarios);

/// Returns the values of these columns for one sample, in the same order. drawn: `scenario` with the sample's
/// arm, from which the values are computed. The value of a target or obstacle that the scenario does not have
/// is NaN. The scenarios' arms must have the same number of joints.
std::vector<double> drawn_values(const std::vector<Scenario>& scenarios, const Scenario& scenario,
                                 const Scenario& drawn);

/// Returns names and texts of arm.urdf and arm.yaml, which describe the simulated arm with payload and
/// friction.
std::vector<std::pair<std::string, std::string>> drawn_arm_files(const Scenario& drawn);

}  // namespace armtune::internal
