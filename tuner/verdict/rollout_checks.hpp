#pragma once
// Adds the checks of finished rollouts to a verdict: completion, joint limits, contacts, and the growth of
// errors over a long time.

#include <string>
#include <vector>

#include "sim/rollout/error_report.hpp"
#include "sim/scenario/scenario.hpp"
#include "tuner/endurance/endurance.hpp"
#include "tuner/study/thresholds.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal {

/// Adds one check for completion and one for each kind of joint limit. Each reports the earliest failure over
/// the scenarios. set: name of the gain set in runs with several; may be empty.
void add_rollout_checks(const std::vector<ScenarioResult>& results, const std::string& set,
                        SimulationVerdict& verdict);

/// Adds a check for each kind of contact that is possible in the scenarios: with an obstacle that has a
/// radius, and, with a cell, of the arm with itself, with a part of the cell and with the floor. results: one
/// per scenario, in their order.
void add_contact_checks(const std::vector<Scenario>& scenarios, const std::vector<ScenarioResult>& results,
                        const std::string& set, SimulationVerdict& verdict);

/// Adds a note for each scenario in which a joint shakes (see shake_watch.hpp).
void add_shake_notes(const std::vector<ScenarioResult>& results, const std::string& set,
                     SimulationVerdict& verdict);

/// Lists as not checked the kinds of contact that are not possible in some of the scenarios. Without a cell
/// none of them is checked.
void add_unchecked_contacts(const std::vector<Scenario>& scenarios, SimulationVerdict& verdict);

/// Lists as not checked that the rotor inertia may differ from the estimate, if a scenario's is an estimate.
void add_unchecked_rotors(const std::vector<Scenario>& scenarios, SimulationVerdict& verdict);

/// Adds a check of the limits in the extended scenarios, and one of the growth of errors. If no scenario ran
/// to its end with errors to compare, the growth is listed as not checked instead.
void add_endurance_checks(const std::vector<EnduranceResult>& results, const VerdictThresholds& thresholds,
                          const std::string& set, SimulationVerdict& verdict);

/// Lists as not checked what the simulated scenarios do not cover, each with the command that checks it, and
/// what no simulation can check. extended: true if every scenario was extended.
void add_unchecked(const std::vector<Scenario>& scenarios, bool extended, SimulationVerdict& verdict);

}  // namespace armtune::internal
