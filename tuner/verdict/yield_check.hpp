#pragma once
// The check of the yield: the share of random arms that keep their limits.

#include <vector>

#include "tuner/robustness/monte_carlo.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal {

/// Returns how many of the samples keep their limits, against the share that is asked for, and what is broken
/// most often: scenario, limit and, of velocity limits, the joint. samples: at least one.
Check yield_check(const std::vector<Scenario>& scenarios, const std::vector<MonteCarloSample>& samples,
                  double asked);

/// Returns, for example, "9 of 10 random arms keep the limits and saturate in at most 1 % of the
/// periods (95 % confidence 59.6 to 98.2 %)".
std::string kept_text(const std::vector<MonteCarloSample>& samples);

/// The verdict on random arms alone, with what they leave unchecked: the arm's own limits too, where
/// options.limits replaces them. samples: at least one.
SimulationVerdict yield_verdict(const std::vector<Scenario>& scenarios,
                                const std::vector<MonteCarloSample>& samples,
                                const MonteCarloOptions& options);

/// Returns, for example, "the default spread of arms, payloads up to 5 kg". whose: "the default".
std::string spread_text(const std::string& whose, const Perturbation& perturbation);

}  // namespace armtune::internal
