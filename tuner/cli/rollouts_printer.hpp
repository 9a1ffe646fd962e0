#pragma once
// What `armtune simulate` and `armtune compare` print of their sessions' outcomes.

#include <string>
#include <vector>

#include "tuner/session/compare_session.hpp"

namespace armtune::internal::cli {

/// gains: as the command line names them.
void print_simulated(const SimulateOutcome& outcome, const RolloutSettings& settings,
                     const std::string& gains);
/// metrics: those that the table has.
void print_compared(const CompareOutcome& outcome, const RolloutSettings& settings,
                    const std::vector<Metric>& metrics);

}  // namespace armtune::internal::cli
