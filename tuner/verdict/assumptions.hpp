#pragma once
// What the simulation checks assume of an arm, for the verdict's "Assumes:".

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/plant/engine.hpp"
#include "sim/plant/stepper.hpp"
#include "sim/scenario/scenario.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal {

/// Adds what the checks assume of the scenarios' arms, such as rotor inertia that a robot file leaves out,
/// and of the stepper that simulated them.
void add_assumptions(const std::vector<Scenario>& scenarios, Stepper stepper, SimulationVerdict& verdict);

/// Adds that Simbody did not simulate `which`, such as "the scenarios", where another engine did so alone.
void add_engine_assumption(Engine engine, const std::string& which, SimulationVerdict& verdict);

/// Adds what is taken for granted of the robot's own controller, where that is whose gains these are.
void add_controller_assumption(const std::vector<Scenario>& scenarios, const Gains& gains,
                               SimulationVerdict& verdict);

/// The random arms of a yield that the engine simulated alone: those that break a limit Simbody simulates
/// again.
inline constexpr const char* kArmsThatKept = "the random arms that keep their limits";

}  // namespace armtune::internal
