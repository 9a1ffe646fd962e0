#pragma once
// Warns about scenarios that no gains can complete, and about scenarios that the chosen kind of controller
// cannot complete. The checks are made before anything is simulated.

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/scenario/scenario.hpp"
#include "tuner/session/observer.hpp"

namespace armtune::internal {

/// Warns if the arm cannot follow the scenario's path (task_trouble.hpp), for example because the path leaves
/// the workspace or a joint's limits, or leads through a singularity. Also warns if the path begins only
/// after the scenario ends. It also warns if the controller does not adapt and the scenario gives it no model
/// of the arm. Throws InputError as refuse_winding does. Returns the warnings, for the verdict's notes.
std::vector<std::string> warn_of_task(const Scenario& scenario, const Gains& gains,
                                      SessionObserver& observer);

/// Warns about implausible numbers in the robot files of the scenarios, once for each arm (see
/// plausibility.hpp).
void warn_of_doubts(const std::vector<Scenario>& scenarios, SessionObserver& observer);

/// Throws InputError if the path itself moves a joint beyond its position limits within the scenario's
/// duration. An example is a closed path along which a joint turns farther with every lap. No gains can
/// prevent this.
void refuse_winding(const Scenario& scenario, const Gains& gains);

}  // namespace armtune::internal
