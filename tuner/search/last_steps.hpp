#pragma once
// Plans the last steps of a tuning that searched in armtune's own dynamics: Simbody evaluates the best points
// found, and a short search in Simbody refines the best of them. These functions choose the points, and
// reserve a part of the evaluations and of the wall time.

#include <optional>
#include <vector>

#include "tuner/evaluation/evaluator.hpp"
#include "tuner/search/seen.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {

/// Initial step of the short search in Simbody, as a fraction of the range between the bounds.
constexpr double kLastStep = 0.02;

/// Returns the points found in armtune's own dynamics that Simbody has to simulate: the best ones, the best
/// inside the bounds of the search (Seen::best_inside) and the best of the sweep. Points that Simbody has
/// already evaluated are left out. searched, judged: the evaluations in armtune's own dynamics and in
/// Simbody.
std::vector<Candidate> to_judge(const Seen& searched, const std::optional<Evaluation>& best_of_sweep,
                                const Seen& judged);

/// Returns the number of evaluations reserved for the last steps: verify_share of the study's
/// max_evaluations, but at least as many as to_judge may return.
long kept_evaluations(const Study& study);

/// Returns the engine of sweep and search. It is the study's engine, or Simbody if the evaluations do not
/// suffice for the start gains in both engines and the last steps.
Engine engine_of_search(const Study& study);

/// Returns the number of the study's evaluations that sweep and search may use. The evaluations of the start
/// gains and of the last steps do not count.
long evaluations_to_search(const Study& study);

/// Returns the part of the study's max_minutes that is reserved for the last steps [s]. It is verify_share of
/// max_minutes, but at least the time to simulate all points that to_judge may return, and at most the time
/// to simulate kept_evaluations(study) points. one: time that Simbody takes to simulate one point [s].
double kept_seconds(const Study& study, double one);

}  // namespace armtune::internal
