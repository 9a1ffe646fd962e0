#include "tuner/search/giving_up.hpp"

namespace armtune {

std::optional<Outdone> giving_up(const Study& study, const std::optional<Objective>& objective) {
  const bool one_value = study.solver.constraints == ConstraintHandling::kPenalty;
  if (!study.end_outdone || !one_value || study.robust || !objective) return {};
  const double penalty = study.solver.penalty;
  // One scenario, nothing of which is known before its end: there is nothing left to save then.
  const std::vector<std::optional<RolloutResult>> none_yet(results_per_evaluation(study));
  if (none_yet.size() == 1 && objective->end_cost(0, none_yet, penalty, 0.0).shares.empty()) return {};
  Outdone outdone;
  outdone.end = [&objective, penalty](std::size_t scenario,
                                      const std::vector<std::optional<RolloutResult>>& finished, double bar) {
    return objective->end_cost(scenario, finished, penalty, bar);
  };
  outdone.above = [&objective, penalty](const std::vector<RolloutResult>& results, double bar) {
    Evaluation e;
    e.results = results;
    objective->judge(e);
    return penalised(e, penalty) > bar;
  };
  return outdone;
}

}  // namespace armtune
