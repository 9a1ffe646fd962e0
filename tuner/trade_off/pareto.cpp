#include "tuner/trade_off/pareto.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/common/error.hpp"
#include "tuner/journal/evaluator.hpp"
#include "tuner/search/together.hpp"
#include "tuner/trade_off/archive.hpp"
#include "tuner/trade_off/level_grid.hpp"

namespace armtune {
namespace {

/// Share of the budget for the least of the first criterion, and of each other.
constexpr double kFirstAnchorShare = 0.25;
constexpr double kAnchorShare = 0.08;
/// A neighbour is near: the search of a level begins with this part of the study's initial step.
constexpr double kLevelStep = 0.4;
/// Linear models need n + 1 points where quadratic ones need 2 n + 1, and constraints stay constraints: what
/// a short search from a neighbour wants.
constexpr const char* kLevelAlgorithm = "COBYLA";

struct Known {
  SolverValue value;  ///< of the study
  Costs costs;
};

/// One search: criterion k becomes least, all others held at or under `levels` (infinite: free).
struct Aim {
  std::size_t k = 0;
  Costs levels;
  std::vector<double> x;  ///< where it begins
  long budget = 0;
  SolverOptions solver;
};

class Search {
 public:
  Search(const Study& study, const ParetoOptions& options, Workers& workers, const std::atomic<bool>& stop,
         const ParetoCallbacks& callbacks, Journal* journal)
      : study_(study),
        options_(options),
        callbacks_(callbacks),
        evaluator_(study, workers, stop, journal),
        box_(study.warm ? warm_point(study.space, *study.warm) : WarmPoint{}) {}

  bool start();
  /// Searches for all aims at once.
  void minimise(const char* phase, const std::string& shown, const std::vector<Aim>& aims);
  void anchors();
  void levels();
  ParetoResult result() &&;

 private:
  /// Simulates candidates and takes them in, in order. False if the run was interrupted.
  bool evaluate(const std::vector<Candidate>& candidates);
  void take_in(const char* phase, Evaluation e);
  void serve(const char* phase, const std::vector<Aim>& aims, std::vector<long>& left,
             std::vector<Request>& requests);
  SolverValue seen_from(const Aim& aim, const Known& known) const;
  void check_reference(const Costs& start) const;
  Costs held_for(std::size_t k) const;
  Aim level(const std::vector<std::size_t>& digits, long budget) const;
  Costs free_levels() const { return Costs(options_.criteria.size(), HUGE_VAL); }

  const Study& study_;
  const ParetoOptions& options_;
  const ParetoCallbacks& callbacks_;
  Evaluator evaluator_;
  WarmPoint box_;  ///< empty without a warm start
  std::optional<Objective> objective_;
  std::map<std::vector<double>, Known> known_;
  Archive archive_;
  std::vector<Costs> axes_;  ///< levels along each criterion but the first
  ParetoResult out_;
  std::string shown_;
};

bool Search::evaluate(const std::vector<Candidate>& candidates) {
  const Engine engine = objective_ ? study_.engine : Engine::kSimbody;  // the start's figures are reported
  out_.interrupted =
      !evaluator_.next(candidates, {engine, end_limits(objective_)},
                       [this](const char* phase, Evaluation e) { take_in(phase, std::move(e)); });
  return !out_.interrupted;
}

void Search::take_in(const char* phase, Evaluation e) {
  ParetoPoint point;
  point.evaluation = out_.evaluations++;
  point.e = std::move(e);
  const bool first = !objective_;
  if (first)
    objective_.emplace(study_.terms, study_.constraints, study_.scenarios, point.e.results, study_.source);
  objective_->judge(point.e);
  for (const Criterion& criterion : options_.criteria) {
    point.costs.push_back(cost(criterion, point.e, study_.scenarios));
  }
  if (first) {
    check_reference(point.costs);
    if (callbacks_.begin) callbacks_.begin(*objective_);
  }
  known_[point.e.x] = {{point.e.objective, point.e.relative}, point.costs};
  if (callbacks_.evaluated) callbacks_.evaluated(phase, point.e);
  if (out_.evaluations == 1) out_.start = point;
  archive_.add(std::move(point));
  if (callbacks_.progress) {
    callbacks_.progress({shown_, out_.evaluations, options_.max_evaluations, archive_.points().size()});
  }
}

bool Search::start() {
  shown_ = "start";
  if (!evaluate({{"start", study_.space.start_point()}})) return false;
  if (!study_.warm || known_.contains(box_.x) || out_.evaluations >= options_.max_evaluations) return true;
  return evaluate({{"warm", box_.x}});
}

void Search::check_reference(const Costs& start) const {
  for (std::size_t k = 0; k < options_.criteria.size(); ++k) {
    if (std::isfinite(start[k]) && start[k] != 0.0) continue;
    throw InputError(fmt::format(
        "{}: {} of the start gains is {}, which gives the front no reference; name another criterion",
        study_.source, options_.criteria[k].name(), start[k]));
  }
}

/// What an aim's search is told of a point.
SolverValue Search::seen_from(const Aim& aim, const Known& known) const {
  const Costs& reference = out_.start.costs;
  // A criterion that a rollout did not give counts as twice the start's: the study's own constraints say why.
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

/// left: what each aim's budget still allows; a point that two ask for counts for the first.
void Search::serve(const char* phase, const std::vector<Aim>& aims, std::vector<long>& left,
                   std::vector<Request>& requests) {
  std::vector<Candidate> candidates;
  std::set<std::vector<double>> chosen;
  const bool in_time = evaluator_.time_left();
  for (const Request& request : requests) {
    for (const SolverPoint& point : request.points) {
      if (known_.contains(point.x) || chosen.contains(point.x)) continue;
      if (!in_time || left[request.search] < 1) break;
      --left[request.search];
      candidates.push_back({point.difference ? "gradient" : phase, point.x});
      chosen.insert(point.x);
    }
  }
  if (!candidates.empty()) evaluate(candidates);
  for (Request& request : requests) {
    request.go_on = !out_.interrupted;
    for (const SolverPoint& point : request.points) {
      const auto known = known_.find(point.x);
      if (known == known_.end()) break;
      request.values.push_back(seen_from(aims[request.search], known->second));
    }
  }
}

void Search::minimise(const char* phase, const std::string& shown, const std::vector<Aim>& aims) {
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

/// What the other criteria must not exceed while criterion k becomes least: the start's, where any feasible
/// point is known to be that good. A start that breaks constraints may be better than all that keep them.
Costs Search::held_for(std::size_t k) const {
  Costs held = free_levels();
  if (k == 0) return held;
  for (std::size_t c = 0; c < held.size(); ++c) {
    if (c == k) continue;
    const ParetoPoint* least = archive_.best_under(c, free_levels());
    if (least && least->costs[c] <= out_.start.costs[c]) held[c] = out_.start.costs[c];
  }
  return held;
}

void Search::anchors() {
  const auto budget = static_cast<double>(options_.max_evaluations);
  for (std::size_t k = 0; k < options_.criteria.size(); ++k) {
    const Costs held = held_for(k);
    const ParetoPoint* best = archive_.best_under(k, held);
    SolverOptions solver = solver_of(study_);
    if (k > 0) solver.algorithm = kLevelAlgorithm;
    if (k > 0) solver.constraints = ConstraintHandling::kAuto;
    const double share = k == 0 ? kFirstAnchorShare : kAnchorShare;
    minimise("anchor", "least " + options_.criteria[k].name(),
             {{k, held, best ? best->e.x : out_.start.e.x, static_cast<long>(share * budget), solver}});
  }
}

/// Digit i of a level counts steps along criterion i + 1.
Aim Search::level(const std::vector<std::size_t>& digits, long budget) const {
  Aim aim;
  aim.levels = free_levels();
  for (std::size_t a = 0; a < axes_.size(); ++a) aim.levels[a + 1] = axes_[a][digits[a]];
  aim.x = archive_.beginning(aim.levels, out_.start);
  aim.budget = budget;
  aim.solver = solver_of(study_);
  aim.solver.algorithm = kLevelAlgorithm;
  aim.solver.constraints = ConstraintHandling::kAuto;
  aim.solver.initial_step *= kLevelStep;
  return aim;
}

void Search::levels() {
  const ParetoPoint* top = archive_.best_under(0, free_levels());
  if (out_.interrupted || !top) return;
  // From where the first criterion is least (so high the others rise for it) to the least of each other one.
  const Costs high = top->costs;
  for (std::size_t k = 1; k < high.size(); ++k) {
    const ParetoPoint* least = archive_.best_under(k, held_for(k));
    if (!least) least = archive_.best_under(k, free_levels());
    const double low = least ? least->costs[k] : high[k];
    Costs& axis = axes_.emplace_back();
    const auto steps = static_cast<double>(options_.levels - 1);
    for (std::size_t i = 0; i < options_.levels; ++i) {
      axis.push_back(std::lerp(high[k], low, static_cast<double>(i) / steps));
    }
  }
  const auto grid = serpentine(axes_.size(), options_.levels);
  // There and back: what a level finds is its neighbours' beginning, on either side.
  const auto way = searched_together(grid.size());
  const std::size_t searches = 2 * grid.size();
  std::size_t done = 0;
  for (std::size_t g = 0; g < 2 * way.size() && !out_.interrupted; ++g) {
    const auto& group = way[g < way.size() ? g : 2 * way.size() - 1 - g];
    std::vector<Aim> aims;
    const long left = options_.max_evaluations - out_.evaluations;
    const long budget = left / static_cast<long>(searches - done);
    for (const std::size_t place : group) aims.push_back(level(grid[place], budget));
    done += group.size();
    minimise("level", fmt::format("levels {}/{}", done, searches), aims);
  }
  for (const auto& digits : grid) {
    Costs levels = free_levels();
    for (std::size_t a = 0; a < axes_.size(); ++a) levels[a + 1] = axes_[a][digits[a]];
    out_.levels.push_back({levels, 0});
  }
}

ParetoResult Search::result() && {
  settle(out_, archive_.points());
  return std::move(out_);
}

}  // namespace

std::size_t ParetoOptions::searches() const {
  std::size_t count = 2;
  for (std::size_t k = 1; k < criteria.size(); ++k) count *= levels;
  return count;
}

std::size_t ParetoResult::dominating_start() const {
  return static_cast<std::size_t>(std::count_if(
      front.begin(), front.end(), [this](const ParetoPoint& p) { return dominates(p.costs, start.costs); }));
}

void settle(ParetoResult& result, const std::vector<ParetoPoint>& points) {
  std::vector<Costs> costs;
  costs.reserve(points.size());
  for (const ParetoPoint& point : points) costs.push_back(point.costs);
  std::vector<ParetoPoint> front;
  for (const std::size_t i : non_dominated(costs)) front.push_back(points[i]);
  result.front = std::move(front);
  result.hypervolume = result.front.empty() ? 0.0 : hypervolume(costs, result.start.costs);
  for (auto level = result.levels.begin(); level != result.levels.end();) {
    // The front ascends in the first cost: the first point under the level is the best.
    const auto best = std::find_if(result.front.begin(), result.front.end(), [&level](const ParetoPoint& p) {
      for (std::size_t c = 0; c < p.costs.size(); ++c) {
        if (p.costs[c] > level->levels[c]) return false;
      }
      return true;
    });
    level->best = static_cast<std::size_t>(best - result.front.begin());
    level = best == result.front.end() ? result.levels.erase(level) : level + 1;
  }
}

ParetoResult pareto(const Study& study, const ParetoOptions& options, Workers& workers,
                    const std::atomic<bool>& stop, const ParetoCallbacks& callbacks, Journal* journal) {
  Search search(study, options, workers, stop, callbacks, journal);
  std::exception_ptr failure;
  try {
    if (search.start()) {
      search.anchors();
      search.levels();
    }
  } catch (const InputError&) {
    throw;
  } catch (...) {
    failure = std::current_exception();
  }
  ParetoResult result = std::move(search).result();
  result.failure = failure;
  return result;
}

}  // namespace armtune
