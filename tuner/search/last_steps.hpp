#pragma once
// The last steps of a run, on Simbody, after a search in another engine. They judge and refine what the
// search found, and need a part of the evaluations and of the wall time.

#include <optional>
#include <vector>

#include "tuner/evaluation/evaluator.hpp"
#include "tuner/search/seen.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {

/// Initial step of the last search, which starts from the best of another engine; share of the box between
/// the bounds.
constexpr double kLastStep = 0.02;

/// Returns the points of another engine that Simbody has to simulate: the best ones, the best inside the box
/// and the best of the sweep. Points that Simbody has judged already are left out.
std::vector<Candidate> to_judge(const Seen& searched, const std::optional<Evaluation>& best_of_sweep,
                                const Seen& judged);

/// Returns the number of evaluations kept for the last steps: the study's verify_share, and at least as many
/// as to_judge may return.
long kept_evaluations(const Study& study);

/// Returns the engine of sweep and search. It is the study's engine, unless there are too few evaluations for
/// more than the start gains in both engines and the last steps.
Engine engine_of_search(const Study& study);

/// Returns the number of the study's evaluations that sweep and search may use. Those of the start gains and
/// of the last steps are not among them.
long evaluations_to_search(const Study& study);

/// Returns the part of the study's max_minutes that is kept for the last steps [s]. It is verify_share of
/// them, but at least the time to judge what was found, and at most the time of all kept_evaluations. one:
/// time that Simbody takes to simulate one point [s].
double kept_seconds(const Study& study, double one);

}  // namespace armtune::internal
