#pragma once
// Creates random variants of a scenario. For example, masses, friction, payload, delay, noise and the motions
// of targets differ from the scenario's own. The variants show how well gains work if the real arm differs
// from the model. A seed and a sample number determine a variant, whichever other samples are drawn.

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

struct ArmDistribution;

/// The widths of uniform distributions about the scenario's own values. Widths without a unit here are
/// relative [1]. perturbation_fields() gives the meaning of each width.
struct Perturbation {
  double mass = 0.2;
  double center = 0.01;  ///< [m]
  double inertia = 0.2;
  double rotor = 0.2;  ///< if above 0, an estimated rotor inertia varies by up to a factor of kRotorFactor
  double friction = 0.5;
  double payload = 0.0;  ///< [kg]; zero: the payload of the scenario is not changed
  double delay = 1.0;    ///< control periods, a whole number
  double noise = 0.5;
  double theta = 0.1;
  double target_speed = 0.2;
  bool phases = true;  ///< each target and each obstacle starts at a random point of a path that repeats
  /// Joint distribution of the arm's parameters (arm_distribution.hpp), from which arms are drawn too. Null:
  /// none. Set it with draw_from().
  std::shared_ptr<const ArmDistribution> distribution;
};

/// What becomes of a width if arms are drawn from a joint distribution.
enum class BesideDistribution {
  kKept,     ///< its default stays, because it does not concern the arm
  kZero,     ///< its default is zero
  kReplaced  ///< it must be zero, because the distribution takes its place
};

/// A width with its name in YAML and on the command line.
struct PerturbationField {
  const char* name;
  const char* unit;
  const char* meaning;
  double Perturbation::*width;
  double most;         ///< largest width
  bool most_included;  ///< false: the width must stay below `most`, at which the value could become zero
  BesideDistribution beside = BesideDistribution::kKept;
};

/// Returns every width, in order.
std::span<const PerturbationField> perturbation_fields();

/// Returns the default widths of Perturbation, but with payloads of up to three times the heaviest payload of
/// any of the scenarios.
Perturbation default_perturbation(std::span<const Scenario> scenarios);

/// Draws arms from the distribution: sets it, and sets the widths that concern the arm to zero.
void draw_from(std::shared_ptr<const ArmDistribution> distribution, Perturbation& perturbation);

/// Returns a perturbation in which all widths are zero and `phases` is false. A scenario that is perturbed
/// with it changes only in the seed of its noise.
Perturbation no_perturbation();

/// Throws InputError, naming field, value and limit, if a width is not within its limits, if `delay` is not a
/// whole number, or if a distribution takes the place of a width that is not zero. The key of the error is
/// `where` and the field, such as `perturbation/mass`.
void validate(const Perturbation& perturbation, const std::string& where = "perturbation");

/// Returns the scenario with the estimated rotor inertia of the simulated arm multiplied by `factor`. Rotor
/// inertia that is not an estimate does not change, and neither does the controller's model.
Scenario with_rotors_scaled(const Scenario& scenario, double factor);

/// Returns the scenario with random changes of the plant (the simulated arm), of the start value of theta
/// (the controller's dynamic parameters), and of target speeds, phases and noise. The changes are drawn by
/// mt19937_64 and depend on (seed, sample) alone. Factors that the scenario already has are multiplied by the
/// drawn factors. The controller's robot model stays as it is, except for gains of drives, which are part of
/// the arm. Throws InputError if the perturbation is not valid.
Scenario perturbed(const Scenario& scenario, const Perturbation& perturbation, std::uint64_t seed,
                   std::uint64_t sample);

}  // namespace armtune::internal
