#pragma once
// Warns of scenarios that no gains can complete, or that the chosen kind of controller cannot complete. The
// checks are made before anything is simulated.

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/scenario/scenario.hpp"
#include "tuner/session/observer.hpp"

namespace armtune::internal {

/// Warns if the scenario's path leaves the workspace or a joint's limits, runs through a singularity, or
/// begins only after the scenario ends. Also warns if the controller does not adapt and the scenario gives it
/// no model of the arm. Throws InputError if the path itself winds a joint up beyond its limits within the
/// scenario's duration, which no gain prevents. Returns the warnings, for the verdict's notes.
std::vector<std::string> warn_of_task(const Scenario& scenario, const Gains& gains,
                                      SessionObserver& observer);

/// Warns of doubtful properties of the scenarios' arms, once for each arm (see plausibility.hpp).
void warn_of_doubts(const std::vector<Scenario>& scenarios, SessionObserver& observer);

/// Throws InputError if the path itself winds a joint up beyond its limits.
void refuse_winding(const Scenario& scenario, const Gains& gains);

}  // namespace armtune::internal
