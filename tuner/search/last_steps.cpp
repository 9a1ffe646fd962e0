#include "tuner/search/last_steps.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

/// Largest number of points that to_judge() returns: the best ones, the best inside the bounds of the search,
/// and the best of the sweep. Without them there is no result.
constexpr long kToJudge = static_cast<long>(Seen::kBest) + 2;

}  // namespace

std::vector<Candidate> to_judge(const Seen& searched, const std::optional<Evaluation>& best_of_sweep,
                                const Seen& judged) {
  std::vector<Candidate> candidates;
  const auto add = [&](const Evaluation& e) {
    const auto same = [&e](const Candidate& c) { return c.x == e.x; };
    if (judged.at(e.x) || std::any_of(candidates.begin(), candidates.end(), same)) return;
    candidates.push_back({"verify", e.x});
  };
  for (const Evaluation& e : searched.best()) add(e);
  if (searched.best_inside()) add(*searched.best_inside());
  if (best_of_sweep) add(*best_of_sweep);
  return candidates;
}

long kept_evaluations(const Study& study) {
  const double share = std::round(study.verify_share * static_cast<double>(study.max_evaluations));
  return std::max(kToJudge, static_cast<long>(share));
}

Engine engine_of_search(const Study& study) {
  const bool both = study.max_evaluations > 1 + kept_evaluations(study);
  return both ? study.engine : Engine::kSimbody;
}

long evaluations_to_search(const Study& study) {
  const bool native = engine_of_search(study) != Engine::kSimbody;  // it simulates the start gains too
  return study.max_evaluations - 1 - (native ? 1 + kept_evaluations(study) : 0);
}

double kept_seconds(const Study& study, double one) {
  return std::clamp(study.verify_share * 60.0 * study.max_minutes, static_cast<double>(kToJudge) * one,
                    static_cast<double>(kept_evaluations(study)) * one);
}

}  // namespace armtune::internal
