#pragma once
// The check of the yield, which is the share of random arms that keep their limits.

#include <vector>

#include "tuner/robustness/monte_carlo.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal {

/// Returns a check that the yield over the samples is at least `asked`. It names the most frequent failure,
/// that is, the scenario, the limit and, for velocity limits, the joint. samples: at least one.
Check yield_check(const std::vector<Scenario>& scenarios, const std::vector<MonteCarloSample>& samples,
                  double asked);

/// Returns, for example, "9 of 10 random arms keep the limits, with saturated torque in at most 1 % of
/// the control periods (95 % confidence 59.6 to 98.2 %)".
std::string kept_text(const std::vector<MonteCarloSample>& samples);

/// Returns the verdict of a run that simulates only random arms. It lists what is not checked. This includes
/// the arm's own limits if options.limits replaces them. samples: at least one.
SimulationVerdict yield_verdict(const std::vector<Scenario>& scenarios,
                                const std::vector<MonteCarloSample>& samples,
                                const MonteCarloOptions& options);

/// Returns, for example, "the arm differs from its model by no more than the default random changes
/// (payloads up to 5 kg)". whose: the first
/// words of the text: "the default", "the study's" or "the given".
std::string spread_text(const std::string& whose, const Perturbation& perturbation);

}  // namespace armtune::internal
