#include "tuner/search/last_steps.hpp"

#include <algorithm>
#include <cmath>

#include "tuner/search/seen.hpp"

namespace armtune {
namespace {

/// Without these there is no result: the best, the best inside the box, the best of the sweep.
constexpr long kToJudge = static_cast<long>(Seen::kBest) + 2;

}  // namespace

long kept_evaluations(const Study& study) {
  const double share = std::round(study.verify_share * static_cast<double>(study.max_evaluations));
  return std::max(kToJudge, static_cast<long>(share));
}

Engine engine_of_search(const Study& study) {
  const bool both = study.max_evaluations > 1 + kept_evaluations(study);
  return both ? study.engine : Engine::kSimbody;
}

long evaluations_to_search(const Study& study) {
  const bool native = engine_of_search(study) != Engine::kSimbody;  // has a start of its own
  return study.max_evaluations - 1 - (native ? 1 + kept_evaluations(study) : 0);
}

double kept_seconds(const Study& study, double one) {
  return std::clamp(study.verify_share * 60.0 * study.max_minutes, static_cast<double>(kToJudge) * one,
                    static_cast<double>(kept_evaluations(study)) * one);
}

}  // namespace armtune
