#pragma once
// Arms and scenes that differ at random from a scenario's own: how far gains hold away from where they were
// tuned. Sample k of a seed is always the same one, whichever others are drawn.

#include <cstdint>
#include <span>
#include <string>

#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// Widths of uniform distributions about the scenario's own values. perturbation_fields() says what each one
/// means.
struct Perturbation {
  double mass = 0.2;
  double center = 0.01;  ///< [m]
  double inertia = 0.2;
  double rotor = 0.2;  ///< of an estimated rotor inertia any value but 0 means kRotorFactor
  double friction = 0.5;
  double payload = 0.0;  ///< [kg]; zero: the scenario's own stays
  double delay = 1.0;    ///< control periods, a whole number
  double noise = 0.5;
  double theta = 0.1;
  double target_speed = 0.2;
  bool phases = true;  ///< each target and each obstacle starts anywhere on its path
};

/// A width by name, as YAML and the command line spell it.
struct PerturbationField {
  const char* name;
  const char* unit;
  const char* meaning;
  double Perturbation::*width;
  double most;  ///< largest width; 1 itself is refused where it would leave nothing
  bool most_included;
};

/// Every width, in order.
std::span<const PerturbationField> perturbation_fields();

/// The widths unless told otherwise: those of Perturbation, and payloads up to three times the heaviest that
/// one of the scenarios carries.
Perturbation default_perturbation(std::span<const Scenario> scenarios);

/// Nothing differs but the noise's seed: widths of zero, phases as they are.
Perturbation no_perturbation();

/// Throws InputError, with `where` in front, naming field, value and limit.
void validate(const Perturbation& perturbation, const std::string& where = "perturbation");

/// Returns the scenario with the plant's estimated rotor inertia multiplied by `factor`; what the robot file
/// gives and what the controller knows stay as they are.
Scenario with_rotors_scaled(const Scenario& scenario, double factor);

/// The scenario with another plant, other phases and other noise. Drawn by mt19937_64 from (seed, sample)
/// alone. Factors the scenario already has are multiplied; the controller's model stays as it is.
/// Throws InputError if the perturbation is not valid.
Scenario perturbed(const Scenario& scenario, const Perturbation& perturbation, std::uint64_t seed,
                   std::uint64_t sample);

}  // namespace armtune::internal
