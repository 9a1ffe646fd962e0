#pragma once
// The simulation checks at the end of `armtune tune`.

#include <string>

#include "tuner/rollouts/comparison.hpp"
#include "tuner/verdict/search_checks.hpp"

namespace armtune::cli {

/// Makes every check of the search's result: constraints, the start, the arm's own limits in the study's
/// scenarios and, with `deep`, margins, random arms and endurance, with a progress line. simulated: fresh
/// rollouts of the result. What was left out stands under "Not checked".
SimulationVerdict check_search(const Study& study, const TuneResult& result, const Objective& objective,
                               const ComparedSet& simulated, bool deep, int workers);

/// Prints what a search that found nothing better, or nothing feasible, recommends. constraints: the check of
/// that kind, which says what is in the way.
void print_recommendation(const TuneResult& result, const Check& constraints, const std::string& folder);

}  // namespace armtune::cli
