#pragma once
// A word about tasks that no gains, or none of their controller, can do, before anything is simulated.

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/scenario/scenario.hpp"
#include "tuner/session/observer.hpp"

namespace armtune::internal {

/// Warns if the scenario's path leaves the workspace, a joint's limits, or runs through a
/// singularity, and if the controller would have to learn what it cannot. Throws InputError if the
/// path itself winds a joint up beyond its limits within the scenario's duration, which no gain prevents.
/// Returns the warnings, for the verdict's notes.
std::vector<std::string> warn_of_task(const Scenario& scenario, const Gains& gains,
                                      SessionObserver& observer);

/// Warns of what is doubtful about the arms of the scenarios, of each arm once (see plausibility.hpp).
void warn_of_doubts(const std::vector<Scenario>& scenarios, SessionObserver& observer);

/// Throws InputError if the path itself winds a joint up.
void refuse_winding(const Scenario& scenario, const Gains& gains);

}  // namespace armtune::internal
