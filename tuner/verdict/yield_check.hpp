#pragma once
// Checks the yield, that is, the share of random arms that keep their limits.

#include <vector>

#include "tuner/robustness/monte_carlo.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal {

/// Returns a check that the yield over the samples is at least `asked`. It names the most frequent failure,
/// that is, the scenario, the limit and, for velocity limits, the joint. samples: at least one.
Check yield_check(const std::vector<Scenario>& scenarios, const std::vector<MonteCarloSample>& samples,
                  double asked);

/// Returns the yield in words, such as "9 of 10 random arms keep the limits, with saturated torque in at most
/// 1 % of the control periods (95 % confidence 59.6 to 98.2 %)".
std::string kept_text(const std::vector<MonteCarloSample>& samples);

/// Returns the verdict of a run that simulates only random arms. It lists what is not checked, including the
/// arm's own limits that options.limits replaces. samples: at least one.
SimulationVerdict yield_verdict(const std::vector<Scenario>& scenarios,
                                const std::vector<MonteCarloSample>& samples,
                                const MonteCarloOptions& options);

/// Returns the assumption about the random arms, such as "the arm differs from its model by no more than the
/// default random changes (with payloads up to 5 kg)". If they are drawn from a joint distribution, names its
/// file instead, and says which parameters were not drawn or not told by a log. whose: the words before
/// "random changes": "the default", "the study's" or "the given".
std::string spread_text(const std::string& whose, const Perturbation& perturbation);

}  // namespace armtune::internal
