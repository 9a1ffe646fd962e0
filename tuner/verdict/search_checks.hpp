#pragma once
// Adds the checks of a search's result to a verdict: constraints, improvement over the start gains, gains on
// their bounds, stability margins, and random arms.

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "tuner/robustness/margins.hpp"
#include "tuner/search/tune.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal {

/// The result of a search.
enum class SearchOutcome {
  kTuned,           ///< gains that are feasible, and better than the start gains
  kStart,           ///< the start gains, because nothing better was found
  kLeastViolation,  ///< infeasible gains that violate the constraints less than the start gains
};

SearchOutcome outcome_of(const TuneResult& result);

/// Returns the name of the resulting gains for tables: "tuned", "start (kept)" or "least violation".
const char* name(SearchOutcome outcome);

/// Adds a check of the study's constraints in Simbody, and a check that the result is better than the start
/// gains.
void add_search_checks(const Study& study, const TuneResult& result, const Objective& objective,
                       SimulationVerdict& verdict);

/// Adds a note with the names of the gains that lie on a bound of the study, if there are any.
void add_bounds_note(const Study& study, const Gains& gains, SimulationVerdict& verdict);

struct DeepCheckOptions {
  int workers = 1;
  std::function<void(const std::string& what, std::size_t done, std::size_t all)> progress;
};

/// Adds a check of each stability margin at its threshold, in every scenario, in Simbody. If no scenario has
/// velocity noise, the noise margin is listed as not checked. Returns false if `stop` interrupted the checks.
bool add_margin_checks(const Study& study, const Gains& gains, const DeepCheckOptions& options,
                       const std::atomic<bool>& stop, SimulationVerdict& verdict);

/// Adds a check of each margin that is known in every scenario. The check passes if every loop is stable at
/// the nominal value of the margin. The value of the check is the smallest margin over the scenarios.
void add_nominal_checks(const std::vector<Scenario>& scenarios, const std::vector<Margin>& margins,
                        SimulationVerdict& verdict);

/// Adds a check of the yield, that is, the share of random arms that keep their limits. If the study tunes on
/// random arms, the check uses other random arms. Returns false if `stop` interrupted the check.
bool add_yield_check(const Study& study, const Gains& gains, const DeepCheckOptions& options,
                     const std::atomic<bool>& stop, SimulationVerdict& verdict);

}  // namespace armtune::internal
