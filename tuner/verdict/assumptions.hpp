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

/// Adds what the checks assume of the scenarios' arms, such as rotor inertia that a robot file does not give,
/// and of the stepper that simulated them.
void add_assumptions(const std::vector<Scenario>& scenarios, Stepper stepper, SimulationVerdict& verdict);

/// Adds that only another engine, not Simbody, simulated `which`, such as "the scenarios". Adds nothing for
/// Simbody.
void add_engine_assumption(Engine engine, const std::string& which, SimulationVerdict& verdict);

/// Adds the assumptions about the robot's own controller, if the gains belong to such a controller.
void add_controller_assumption(const std::vector<Scenario>& scenarios, const Gains& gains,
                               SimulationVerdict& verdict);

/// Name of the random arms that only another engine than Simbody simulated. Arms that break a limit are
/// simulated again in Simbody.
inline constexpr const char* kArmsThatKept = "the random arms that keep their limits";

}  // namespace armtune::internal
