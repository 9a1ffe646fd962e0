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

/// Adds one check for completion and one for each kind of joint limit. The check for completion reports the
/// first scenario that failed. The check of a limit reports the earliest failure in any scenario. set: name
/// of the gain set, empty if there is only one.
void add_rollout_checks(const std::vector<ScenarioResult>& results, const std::string& set,
                        SimulationVerdict& verdict);

/// Adds a check for each kind of contact that is possible in the scenarios. One kind is contact with an
/// obstacle that has a radius. If the scenario has a cell (the surroundings of the arm), further kinds are
/// contacts of the arm with itself, with a part of the cell, and with the floor. results: one per scenario,
/// in their order.
void add_contact_checks(const std::vector<Scenario>& scenarios, const std::vector<ScenarioResult>& results,
                        const std::string& set, SimulationVerdict& verdict);

/// Adds a note for each scenario in which a joint shakes (see shake_watch.hpp).
void add_shake_notes(const std::vector<ScenarioResult>& results, const std::string& set,
                     SimulationVerdict& verdict);

/// Adds contacts that cannot be detected to the list of things not checked:
/// - contact between two control periods, with the largest amount by which a distance can fall in between;
/// - for each scenario, the kinds of contact that cannot be detected in it. Without a cell, these are
///   contacts of the arm with itself, with the cell and with the floor.
void add_unchecked_contacts(const std::vector<Scenario>& scenarios, SimulationVerdict& verdict);

/// If the rotor inertia is an estimate in any scenario, adds differences from the estimate to the list of
/// things not checked.
void add_unchecked_rotors(const std::vector<Scenario>& scenarios, SimulationVerdict& verdict);

/// Adds a check of the limits in scenarios that were extended to a long time (endurance.hpp), and a check of
/// the growth of errors there. If no extended scenario was completed and has errors to compare, the growth is
/// added to the list of things not checked.
void add_endurance_checks(const std::vector<EnduranceResult>& results, const VerdictThresholds& thresholds,
                          const std::string& set, SimulationVerdict& verdict);

/// Extends the list of things not checked. Adds everything that the simulated scenarios do not cover, with
/// the commands that check it, and everything that no command checks. extended: true if every scenario was
/// extended to a long time.
void add_unchecked(const std::vector<Scenario>& scenarios, bool extended, SimulationVerdict& verdict);

}  // namespace armtune::internal
