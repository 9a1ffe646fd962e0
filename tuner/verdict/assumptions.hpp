#pragma once
// What the simulation checks assume of an arm, for the verdict's "Assumes:".

#include <vector>

#include "sim/plant/stepper.hpp"
#include "sim/scenario/scenario.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal {

/// Adds what the checks assume of the scenarios' arms, such as rotor inertia that a robot file leaves out,
/// and of the stepper that simulated them.
void add_assumptions(const std::vector<Scenario>& scenarios, Stepper stepper, SimulationVerdict& verdict);

}  // namespace armtune::internal
