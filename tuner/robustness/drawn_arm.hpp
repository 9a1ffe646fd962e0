#pragma once
// Describes one random arm of a Monte Carlo analysis, which simulates the gains on many random arms. The
// properties of the arm become columns of samples.csv, or files with the model of the arm.

#include <string>
#include <utility>
#include <vector>

#include "sim/scenario/perturbation.hpp"

namespace armtune::internal {

/// Returns the names of the columns for the parameters that are drawn from a joint distribution, such as
/// distribution/elbow_joint/viscous_friction. Empty without a distribution.
std::vector<std::string> distribution_columns(const Perturbation& perturbation);

/// Returns the values of these columns for one sample, in SI units. A negative payload or delay, which acts
/// as zero, is shown as it was drawn.
std::vector<double> distribution_values(const Perturbation& perturbation, std::uint64_t seed,
                                        std::uint64_t sample);

/// Returns the names of the other columns. For each joint of the first scenario's arm there are
/// drawn/JOINT/mass_factor, inertia_factor, rotor_factor, center_x, center_y, center_z [m], viscous_friction,
/// coulomb_friction and theta_factor. Then come drawn/payload [kg], drawn/delay [control periods],
/// drawn/position_noise [rad, m] and drawn/velocity_noise. For each target and obstacle that any scenario has
/// there are drawn/NAME/speed_factor and drawn/NAME/phase [rad]. Friction is what the scenario adds to that
/// of the arm's model.
std::vector<std::string> drawn_columns(const std::vector<Scenario>& scenarios);

/// Returns the values of these columns for one sample, in the same order. drawn: a copy of `scenario` with
/// the sample's arm; the values are computed from it. If the scenario does not have a target or an obstacle,
/// the values of its columns are NaN. The arms of all scenarios must have the same number of joints.
std::vector<double> drawn_values(const std::vector<Scenario>& scenarios, const Scenario& scenario,
                                 const Scenario& drawn);

/// Returns the names and the texts of two files, arm.urdf and arm.yaml. They describe the simulated arm with
/// its payload and friction.
std::vector<std::pair<std::string, std::string>> drawn_arm_files(const Scenario& drawn);

}  // namespace armtune::internal
