#pragma once
// Arms and scenes that differ at random from a scenario's own: how far gains hold away from where they were
// tuned. Sample k of a seed is always the same one, whichever others are drawn.

#include <cstdint>

#include "sim/scenario/scenario.hpp"

namespace armtune {

/// Widths of uniform distributions about the scenario's own values, relative where no unit is given.
struct Perturbation {
  double mass = 0.2;          ///< of each link's mass, first moment and inertia together, in [0, 1)
  double inertia = 0.2;       ///< of each link's inertia about its centre of mass, in [0, 1)
  double rotor = 0.2;         ///< of each joint's rotor inertia, in [0, 1)
  double friction = 0.5;      ///< of each joint's viscous and Coulomb friction in the scenario, in [0, 1]
  double payload_max = 3.0;   ///< a point mass at the tool in [0, payload_max], the scenario's no more [kg]
  bool phases = true;         ///< each target and each obstacle starts anywhere on its path
  double center = 0.0;        ///< of each coordinate of each link's centre of mass [m]
  int delay_max = 0;          ///< 0 .. delay_max control periods of torque delay on top of the scenario's
  double noise = 0.0;         ///< of the sensors' noise, in [0, 1]
  double theta = 0.0;         ///< of each link's share of theta at the start, in [0, 1)
  double target_speed = 0.0;  ///< of the frequency of each target's path, in [0, 1)
};

/// Throws InputError naming field, value and limit.
void validate(const Perturbation& perturbation);

/// The scenario with another plant, other phases and other noise. Drawn by mt19937_64 from (seed, sample)
/// alone. Factors the scenario already has are multiplied; the controller's model stays as it is.
/// Throws InputError if the perturbation is not valid.
Scenario perturbed(const Scenario& scenario, const Perturbation& perturbation, std::uint64_t seed,
                   std::uint64_t sample);

}  // namespace armtune
