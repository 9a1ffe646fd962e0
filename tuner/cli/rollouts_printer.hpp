#pragma once
// Prints the results of `armtune simulate` and `armtune compare`.

#include <string>
#include <vector>

#include "tuner/session/compare_session.hpp"

namespace armtune::internal::cli {

/// Prints the outcome of `armtune simulate`. gains: name of the gains on the command line.
void print_simulated(const SimulateOutcome& outcome, const RolloutSettings& settings,
                     const std::string& gains);
/// Prints the outcome of `armtune compare`. metrics: the metrics that the table shows.
void print_compared(const CompareOutcome& outcome, const RolloutSettings& settings,
                    const std::vector<Metric>& metrics);

}  // namespace armtune::internal::cli
