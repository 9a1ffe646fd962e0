#include "tuner/trade_off/aimed_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "armtune/error.hpp"
#include "tuner/search/requests.hpp"

namespace armtune::internal {

AimedSearch::AimedSearch(const Study& study, const ParetoOptions& options, CandidateRunner& workers,
                         const std::atomic<bool>& stop, const ParetoCallbacks& callbacks, Journal* journal)
    : study_(study),
      options_(options),
      callbacks_(callbacks),
      evaluator_(study, workers, stop, journal),
      box_(study.warm ? warm_point(study.space, *study.warm) : WarmPoint{}) {}

bool AimedSearch::evaluate(const std::vector<Candidate>& candidates) {
  // The results of the start gains are reported, so Simbody simulates them.
  const Engine engine = objective_ ? study_.engine : Engine::kSimbody;
  out_.interrupted =
      !evaluator_.next(candidates, {engine, end_limits(objective_)},
                       [this](const char* phase, Evaluation e) { take_in(phase, std::move(e)); });
  return !out_.interrupted;
}

void AimedSearch::take_in(const char* phase, Evaluation e) {
  ParetoPoint point;
  point.evaluation = out_.evaluations++;
  point.e = std::move(e);
  const bool first = !objective_;
  if (first)
    objective_.emplace(study_.terms, study_.constraints, simulated_scenarios(study_), point.e.results,
                       where(study_), study_.own_objective);
  objective_->judge(point.e);
  for (const Criterion& criterion : options_.criteria) {
    point.costs.push_back(cost(criterion, point.e, study_.scenarios));
  }
  if (first) {
    check_reference(point.costs);
    if (callbacks_.begin) callbacks_.begin(*objective_);
  }
  Known& known = known_[point.e.x];
  known.value.objective = point.e.objective;
  known.value.constraints = point.e.relative;
  known.costs = point.costs;
  if (callbacks_.evaluated) callbacks_.evaluated(phase, point.e);
  if (out_.evaluations == 1) out_.start = point;
  if (!best_ || better(point.e, *best_)) best_ = point.e;
  archive_.add(std::move(point));
  if (callbacks_.progress) {
    callbacks_.progress({shown_, out_.evaluations, options_.max_evaluations, archive_.points().size()});
  }
}

bool AimedSearch::start() {
  shown_ = "start";
  if (!evaluate({{"start", study_.space.start_point()}})) return false;
  if (!study_.warm || known_.contains(box_.x) || out_.evaluations >= options_.max_evaluations) return true;
  return evaluate({{"warm", box_.x}});
}

void AimedSearch::check_reference(const Costs& start) const {
  for (std::size_t k = 0; k < options_.criteria.size(); ++k) {
    if (std::isfinite(start[k]) && start[k] != 0.0) continue;
    const std::string criterion = options_.criteria[k].name();
    throw InputError(
        InputPlace{where(study_), 0, criterion},
        fmt::format("{} is {} with the start gains; a criterion needs a finite value other than 0 there; "
                    "choose another criterion",
                    criterion, start[k]))
        .with_value(fmt::to_string(start[k]), "finite, and other than 0");
  }
}

/// Returns the value of a point for the search of an aim: the relative cost of its criterion, the study's
/// constraints, and the relative excess over each level.
SolverValue AimedSearch::seen_from(const Aim& aim, const Known& known) const {
  const Costs& reference = out_.start.costs;
  // A criterion without a value gets the start's cost plus the magnitude of this cost. The study's own
  // constraints show why the rollout gave no value.
  const auto relative = [&](std::size_t c) {
    const double cost = known.costs[c];
    return (std::isnan(cost) ? reference[c] + std::abs(reference[c]) : cost) / std::abs(reference[c]);
  };
  SolverValue value = {relative(aim.k), known.value.constraints};
  for (std::size_t c = 0; c < aim.levels.size(); ++c) {
    const bool held = std::isfinite(aim.levels[c]);
    value.constraints.push_back(held ? relative(c) - aim.levels[c] / std::abs(reference[c]) : -1.0);
  }
  return value;
}

/// Simulates the requested points, and answers the requests. left: number of evaluations that each aim may
/// still use. A point that two searches request counts for the first of them.
void AimedSearch::serve(const char* phase, const std::vector<Aim>& aims, std::vector<long>& left,
                        std::vector<Request>& requests) {
  const bool in_time = evaluator_.time_left();
  out_.out_of_time = out_.out_of_time || !in_time;
  const auto candidates = candidates_of(
      requests, phase, [this](const SolverPoint& point) { return known_.contains(point.x); },
      [&](std::size_t search) { return in_time && left[search] > 0 && left[search]-- > 0; });
  if (!candidates.empty()) evaluate(candidates);
  answer(requests, !out_.interrupted, [&](std::size_t search, const SolverPoint& point) {
    const auto known = known_.find(point.x);
    return known == known_.end() ? std::nullopt : std::optional(seen_from(aims[search], known->second));
  });
}

void AimedSearch::minimise(const char* phase, const std::string& shown, const std::vector<Aim>& aims) {
  if (out_.interrupted) return;
  shown_ = shown;
  std::vector<JoinedSearch> searches;
  std::vector<long> left;
  for (const Aim& aim : aims) {
    JoinedSearch& search = searches.emplace_back();
    search.problem.start = aim.x;
    search.problem.lower = box_.lower;
    search.problem.upper = box_.upper;
    for (std::size_t i = 0; i < box_.x.size(); ++i) {
      search.problem.start[i] = std::clamp(aim.x[i], box_.lower[i], box_.upper[i]);
    }
    search.problem.constraint_count = objective_->constraint_count() + aim.levels.size();
    search.options = aim.solver;
    left.push_back(aim.budget);
  }
  minimize_together(searches, [&](std::vector<Request>& requests) { serve(phase, aims, left, requests); });
}

}  // namespace armtune::internal
