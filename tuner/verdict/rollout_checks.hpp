#pragma once
// Checks of rollouts that were made: completion and the arm's own limits.

#include <string>
#include <vector>

#include "sim/rollout/error_report.hpp"
#include "sim/scenario/scenario.hpp"
#include "tuner/endurance/endurance.hpp"
#include "tuner/study/thresholds.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal {

/// Adds one check for completion and one for each kind of joint limit, each with the earliest fault over the
/// scenarios. set: name of the gain set, for runs with several; may be empty.
void add_rollout_checks(const std::vector<ScenarioResult>& results, const std::string& set,
                        SimulationVerdict& verdict);

/// Adds a check for each kind of contact that the scenarios can have: with an obstacle that has a radius, and
/// where there is a cell of the arm with itself, with a part of the cell and with the floor. results: one per
/// scenario, in their order.
void add_contact_checks(const std::vector<Scenario>& scenarios, const std::vector<ScenarioResult>& results,
                        const std::string& set, SimulationVerdict& verdict);

/// Adds a note for each scenario in which a joint shakes (see shake_watch.hpp).
void add_shake_notes(const std::vector<ScenarioResult>& results, const std::string& set,
                     SimulationVerdict& verdict);

/// Lists as not checked the kinds of contact that some of the scenarios cannot have: without a cell none of
/// them is looked for.
void add_unchecked_contacts(const std::vector<Scenario>& scenarios, SimulationVerdict& verdict);

/// Lists as not checked that the rotor inertia may be another one, where a scenario's is an estimate.
void add_unchecked_rotors(const std::vector<Scenario>& scenarios, SimulationVerdict& verdict);

/// Adds a check for limits in the extended scenarios, and one for the growth of errors. Where no scenario ran
/// to its end with errors to compare, the growth is listed as not checked instead.
void add_endurance_checks(const std::vector<EnduranceResult>& results, const VerdictThresholds& thresholds,
                          const std::string& set, SimulationVerdict& verdict);

/// Lists as not checked what simulating the scenarios leaves out, each with the command that checks it, and
/// what no simulation can check. extended: whether every scenario was extended.
void add_unchecked(const std::vector<Scenario>& scenarios, bool extended, SimulationVerdict& verdict);

}  // namespace armtune::internal
