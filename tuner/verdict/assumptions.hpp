#pragma once
// Lists what the checks assume about an arm and about its simulation. The verdict on a gain set shows this
// list after the word "Assumes:".

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/plant/engine.hpp"
#include "sim/plant/stepper.hpp"
#include "sim/scenario/scenario.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal {

/// Adds the assumptions about the scenarios' arms, such as rotor inertia that a robot file does not give, and
/// about the simulation with this integration method. examine: false leaves out implausible numbers in robot
/// files (plausibility.hpp), because finding them takes some milliseconds for each arm.
void add_assumptions(const std::vector<Scenario>& scenarios, Stepper stepper, SimulationVerdict& verdict,
                     bool examine = true);

/// Adds the assumption that the results of an engine other than Simbody are correct. which: what this engine
/// simulated, such as "the scenarios". Adds nothing if the engine is Simbody.
void add_engine_assumption(Engine engine, const std::string& which, SimulationVerdict& verdict);

/// Adds the assumptions about the robot's own controller, if the gains belong to such a controller.
void add_controller_assumption(const std::vector<Scenario>& scenarios, const Gains& gains,
                               SimulationVerdict& verdict);

/// The argument `which` of add_engine_assumption for the check on random arms. If another engine simulates
/// these arms, Simbody simulates again only those that break a limit. The results of the others are therefore
/// not confirmed by Simbody.
inline constexpr const char* kArmsThatKept = "the random arms that keep their limits";

}  // namespace armtune::internal
