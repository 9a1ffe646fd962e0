#pragma once
// Plans the last steps of a tuning run that searched in armtune's own dynamics. Simbody, the dynamics library
// with which results are verified, evaluates the best points found. A short search in Simbody then refines
// the best of them. These functions choose the points, and reserve a part of the evaluations and of the wall
// time.

#include <optional>
#include <vector>

#include "tuner/evaluation/evaluator.hpp"
#include "tuner/search/seen.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {

/// Initial step of the short search in Simbody, as a fraction of the range between the bounds.
constexpr double kLastStep = 0.02;

/// Returns the points found in armtune's own dynamics that Simbody has to simulate: the best ones, the best
/// inside the bounds of the search (Seen::best_inside) and the best of the coarse sweep (sweep.hpp). Points
/// that Simbody has already evaluated are left out. searched: evaluations in armtune's own dynamics; judged:
/// evaluations in Simbody.
std::vector<Candidate> to_judge(const Seen& searched, const std::optional<Evaluation>& best_of_sweep,
                                const Seen& judged);

/// Returns the number of evaluations reserved for the last steps: verify_share of the study's
/// max_evaluations, but at least as many as to_judge may return.
long kept_evaluations(const Study& study);

/// Returns the dynamics engine of sweep and search. This is the study's engine, or Simbody if the study has
/// too few evaluations for the start gains in both engines and the last steps.
Engine engine_of_search(const Study& study);

/// Returns the number of the study's evaluations that sweep and search may use. The evaluations of the start
/// gains and of the last steps do not count.
long evaluations_to_search(const Study& study);

/// Returns the part of the study's max_minutes that is reserved for the last steps [s]. This is verify_share
/// of max_minutes, but at least the time to simulate all points that to_judge may return, and at most the
/// time to simulate kept_evaluations(study) points. one: time that Simbody takes to simulate one point [s].
double kept_seconds(const Study& study, double one);

}  // namespace armtune::internal
