#pragma once
// The last steps on Simbody after a search in another engine, and what that leaves for them: evaluations,
// and wall time.

#include <optional>
#include <vector>

#include "tuner/evaluation/evaluator.hpp"
#include "tuner/search/seen.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {

/// Initial step of the last search, from the best of another engine: of the box between the bounds.
constexpr double kLastStep = 0.02;

/// What Simbody has to see of what another engine found: its best, and those of the sweep, but for what is
/// judged already.
std::vector<Candidate> to_judge(const Seen& searched, const std::optional<Evaluation>& best_of_sweep,
                                const Seen& judged);

/// The study's verify_share, and at least what it takes to judge what was found.
long kept_evaluations(const Study& study);

/// What sweep and search run in: the study's engine, unless the evaluations do no more than start both.
Engine engine_of_search(const Study& study);

/// Of the study's evaluations, those for sweep and search: the start's and the last steps' are not.
long evaluations_to_search(const Study& study);

/// Of the study's max_minutes [s]: verify_share of them, but no less than judging what was found takes, and
/// no more than all kept_evaluations do. one: how long Simbody simulates one [s].
double kept_seconds(const Study& study, double one);

}  // namespace armtune::internal
