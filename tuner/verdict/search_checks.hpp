#pragma once
// Checks of what a search found: constraints, the start, gains on their bounds, margins, random arms.

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "tuner/robustness/margins.hpp"
#include "tuner/search/tune.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal {

/// What a search ended with.
enum class SearchOutcome {
  kTuned,           ///< feasible, and better than the start
  kStart,           ///< nothing better than the start gains was found
  kLeastViolation,  ///< nothing feasible was found; the point breaks its constraints less than the start does
};

SearchOutcome outcome_of(const TuneResult& result);

/// The name of the gains that a search ended with, for tables: "tuned", "start (kept)" or "least violation".
const char* name(SearchOutcome outcome);

/// Adds the study's constraints, as Simbody saw them, and whether the result is better than the start.
void add_search_checks(const Study& study, const TuneResult& result, const Objective& objective,
                       SimulationVerdict& verdict);

/// Adds a note that names the gains that lie on a bound of the study, if there are any.
void add_bounds_note(const Study& study, const Gains& gains, SimulationVerdict& verdict);

struct DeepCheckOptions {
  int workers = 1;
  std::function<void(const std::string& what, std::size_t done, std::size_t all)> progress;
};

/// Adds a check for each margin at its threshold, in every scenario, by Simbody. Returns false if `stop` cut
/// it short.
bool add_margin_checks(const Study& study, const Gains& gains, const DeepCheckOptions& options,
                       const std::atomic<bool>& stop, SimulationVerdict& verdict);

/// Adds the yield over random arms, drawn otherwise than those that a study tunes on. Returns false if `stop`
/// cut it short.
bool add_yield_check(const Study& study, const Gains& gains, const DeepCheckOptions& options,
                     const std::atomic<bool>& stop, SimulationVerdict& verdict);

}  // namespace armtune::internal
