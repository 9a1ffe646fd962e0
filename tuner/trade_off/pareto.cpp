#include "tuner/trade_off/pareto.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "core/common/error.hpp"
#include "tuner/journal/evaluator.hpp"
#include "tuner/work/simulate_points.hpp"

namespace armtune {
namespace {

/// Share of the budget for the least of the first criterion, and of each other.
constexpr double kFirstAnchorShare = 0.25;
constexpr double kAnchorShare = 0.08;
/// A neighbour is near: the search of a level begins with this part of the study's initial step.
constexpr double kLevelStep = 0.4;
/// How much a relative excess over a level weighs where the best known point to begin a level at is chosen.
constexpr double kExcessWeight = 10.0;
/// Linear models need n + 1 points where quadratic ones need 2 n + 1, and constraints stay constraints: what
/// a short search from a neighbour wants.
constexpr const char* kLevelAlgorithm = "COBYLA";

struct Known {
  SolverValue value;  ///< of the study
  Costs costs;
};

class Search {
 public:
  Search(const Study& study, const ParetoOptions& options, Workers& workers, const std::atomic<bool>& stop,
         const ParetoCallbacks& callbacks, Journal* journal)
      : study_(study), options_(options), callbacks_(callbacks), evaluator_(study, workers, stop, journal) {}

  bool start();
  /// Minimises criterion k, all others held at or under `levels` (infinite: free), from x.
  void minimise(const char* phase, const std::string& shown, std::size_t k, const Costs& levels,
                std::vector<double> x, long budget, const SolverOptions& solver);
  void anchors();
  void levels();
  ParetoResult result() &&;

 private:
  bool evaluate(const char* phase, const std::vector<double>& x);
  void check_reference(const Costs& start) const;
  std::optional<std::size_t> best_under(std::size_t k, const Costs& levels) const;
  const std::vector<double>& beginning(const Costs& levels) const;
  Costs held_for(std::size_t k) const;
  void search_level(const std::vector<std::size_t>& digits, const std::string& shown, long budget);
  Costs free_levels() const { return Costs(options_.criteria.size(), HUGE_VAL); }

  const Study& study_;
  const ParetoOptions& options_;
  const ParetoCallbacks& callbacks_;
  Evaluator evaluator_;
  std::optional<Objective> objective_;
  std::map<std::vector<double>, Known> known_;
  std::vector<ParetoPoint> archive_;  ///< feasible, none dominated by another
  std::vector<Costs> axes_;           ///< levels along each criterion but the first
  ParetoResult out_;
  std::string shown_;
};

bool Search::evaluate(const char* phase, const std::vector<double>& x) {
  auto evaluations = evaluator_.next(phase, {x}, end_limits(objective_));
  if (!evaluations) {
    out_.interrupted = true;
    return false;
  }
  ParetoPoint point;
  point.evaluation = out_.evaluations++;
  point.e = std::move(evaluations->front());
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
  known_[x] = {{point.e.objective, point.e.relative}, point.costs};
  if (callbacks_.evaluated) callbacks_.evaluated(phase, point.e);
  if (out_.evaluations == 1) out_.start = point;
  const auto beats = [&point](const ParetoPoint& other) {
    return dominates(other.costs, point.costs) || other.costs == point.costs;
  };
  const bool whole =
      std::none_of(point.costs.begin(), point.costs.end(), [](double c) { return std::isnan(c); });
  if (point.e.feasible && whole && std::none_of(archive_.begin(), archive_.end(), beats)) {
    std::erase_if(archive_,
                  [&point](const ParetoPoint& other) { return dominates(point.costs, other.costs); });
    archive_.push_back(std::move(point));
  }
  if (callbacks_.progress) {
    callbacks_.progress({shown_, out_.evaluations, options_.max_evaluations, archive_.size()});
  }
  return true;
}

bool Search::start() {
  shown_ = "start";
  return evaluate("start", study_.space.start_point());
}

void Search::check_reference(const Costs& start) const {
  for (std::size_t k = 0; k < options_.criteria.size(); ++k) {
    if (std::isfinite(start[k]) && start[k] != 0.0) continue;
    throw InputError(fmt::format(
        "{}: {} of the start gains is {}, which gives the front no reference; name another criterion",
        study_.source, options_.criteria[k].name(), start[k]));
  }
}

void Search::minimise(const char* phase, const std::string& shown, std::size_t k, const Costs& levels,
                      std::vector<double> x, long budget, const SolverOptions& solver) {
  if (out_.interrupted || budget < 1) return;
  shown_ = shown;
  const Costs& reference = out_.start.costs;
  SolverProblem problem;
  problem.start = std::move(x);
  problem.constraint_count = objective_->constraint_count() + levels.size();
  long left = budget;
  long repeats = 0;
  problem.evaluate = [&](const std::vector<double>& point, SolverValue& value) {
    auto found = known_.find(point);
    if (found == known_.end()) {
      repeats = 0;
      if (left-- <= 0 || !evaluator_.time_left() || !evaluate(phase, point)) return false;
      found = known_.find(point);
    } else if (++repeats > budget) {
      return false;  // going round in a circle
    }
    const Known& known = found->second;
    // A criterion that a rollout did not give counts as twice the start's: the study's own constraints say
    // why.
    const auto relative = [&](std::size_t c) {
      const double cost = known.costs[c];
      return (std::isnan(cost) ? reference[c] + std::abs(reference[c]) : cost) / std::abs(reference[c]);
    };
    value.objective = relative(k);
    value.constraints = known.value.constraints;
    for (std::size_t c = 0; c < levels.size(); ++c) {
      const bool held = std::isfinite(levels[c]);
      value.constraints.push_back(held ? relative(c) - levels[c] / std::abs(reference[c]) : -1.0);
    }
    return true;
  };
  armtune::minimize(problem, solver);
}

std::optional<std::size_t> Search::best_under(std::size_t k, const Costs& levels) const {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < archive_.size(); ++i) {
    const Costs& costs = archive_[i].costs;
    bool under = true;
    for (std::size_t c = 0; c < levels.size(); ++c) under = under && costs[c] <= levels[c];
    if (under && (!best || costs[k] < archive_[*best].costs[k])) best = i;
  }
  return best;
}

/// The known point to begin a level's search at: the best once what it exceeds the level by is paid for.
/// Mostly the neighbour's.
const std::vector<double>& Search::beginning(const Costs& levels) const {
  const Costs& reference = out_.start.costs;
  const std::vector<double>* best = &out_.start.e.x;
  double least = HUGE_VAL;
  for (const ParetoPoint& point : archive_) {
    double merit = point.costs[0] / std::abs(reference[0]);
    for (std::size_t c = 1; c < levels.size(); ++c) {
      merit += kExcessWeight * std::max(0.0, (point.costs[c] - levels[c]) / std::abs(reference[c]));
    }
    if (merit < least) {
      least = merit;
      best = &point.e.x;
    }
  }
  return *best;
}

/// What the other criteria must not exceed while criterion k becomes least: the start's, where any feasible
/// point is known to be that good. A start that breaks constraints may be better than all that keep them.
Costs Search::held_for(std::size_t k) const {
  Costs held = free_levels();
  if (k == 0) return held;
  for (std::size_t c = 0; c < held.size(); ++c) {
    if (c == k) continue;
    const auto least = best_under(c, free_levels());
    if (least && archive_[*least].costs[c] <= out_.start.costs[c]) held[c] = out_.start.costs[c];
  }
  return held;
}

void Search::anchors() {
  const auto budget = static_cast<double>(options_.max_evaluations);
  for (std::size_t k = 0; k < options_.criteria.size(); ++k) {
    const Costs held = held_for(k);
    const auto best = best_under(k, held);
    SolverOptions solver = study_.solver;
    if (k > 0) solver.algorithm = kLevelAlgorithm;
    if (k > 0) solver.constraints = ConstraintHandling::kAuto;
    minimise("anchor", "least " + options_.criteria[k].name(), k, held,
             best ? archive_[*best].e.x : out_.start.e.x,
             static_cast<long>((k == 0 ? kFirstAnchorShare : kAnchorShare) * budget), solver);
  }
}

/// Digit i of a level counts steps along criterion i + 1.
void Search::search_level(const std::vector<std::size_t>& digits, const std::string& shown, long budget) {
  Costs levels = free_levels();
  std::string text = shown;
  for (std::size_t a = 0; a < axes_.size(); ++a) {
    levels[a + 1] = axes_[a][digits[a]];
    const bool large = options_.criteria[a + 1].larger_is_better();
    text += fmt::format(" {} {} {:.4g}", options_.criteria[a + 1].name(),
                        large ? ">=" : "<=", large ? -levels[a + 1] : levels[a + 1]);
  }
  SolverOptions solver = study_.solver;
  solver.algorithm = kLevelAlgorithm;
  solver.constraints = ConstraintHandling::kAuto;
  solver.initial_step *= kLevelStep;
  minimise("level", text, 0, levels, beginning(levels), budget, solver);
}

void Search::levels() {
  const auto top = best_under(0, free_levels());
  if (out_.interrupted || !top) return;
  // From where the first criterion is least (so high the others rise for it) to the least of each other one.
  const Costs high = archive_[*top].costs;
  for (std::size_t k = 1; k < high.size(); ++k) {
    auto least = best_under(k, held_for(k));
    if (!least) least = best_under(k, free_levels());
    const double low = least ? archive_[*least].costs[k] : high[k];
    Costs& axis = axes_.emplace_back();
    const auto steps = static_cast<double>(options_.levels - 1);
    for (std::size_t i = 0; i < options_.levels; ++i) {
      axis.push_back(std::lerp(high[k], low, static_cast<double>(i) / steps));
    }
  }
  // Serpentine through the grid: a level differs from the one before in one step of one criterion.
  std::vector<std::vector<std::size_t>> grid(1);
  for (std::size_t a = axes_.size(); a-- > 0;) {
    std::vector<std::vector<std::size_t>> finer;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      for (std::size_t d = 0; d < axes_[a].size(); ++d) {
        finer.push_back(grid[i]);
        finer.back().insert(finer.back().begin(), i % 2 == 0 ? d : axes_[a].size() - 1 - d);
      }
    }
    grid = std::move(finer);
  }
  // There and back: what a level finds is its neighbours' beginning, on either side.
  const std::size_t searches = 2 * grid.size();
  for (std::size_t i = 0; i < searches && !out_.interrupted; ++i) {
    const std::size_t place = i < grid.size() ? i : searches - 1 - i;
    const long left = options_.max_evaluations - out_.evaluations;
    search_level(grid[place], fmt::format("{}/{}", i + 1, searches), left / static_cast<long>(searches - i));
  }
  for (const auto& digits : grid) {
    Costs levels = free_levels();
    for (std::size_t a = 0; a < axes_.size(); ++a) levels[a + 1] = axes_[a][digits[a]];
    out_.levels.push_back({levels, 0});
  }
}

ParetoResult Search::result() && {
  std::vector<Costs> costs;
  costs.reserve(archive_.size());
  for (const ParetoPoint& point : archive_) costs.push_back(point.costs);
  for (const std::size_t i : non_dominated(costs)) out_.front.push_back(archive_[i]);
  if (!out_.front.empty()) out_.hypervolume = hypervolume(costs, out_.start.costs);
  for (auto level = out_.levels.begin(); level != out_.levels.end();) {
    // The front ascends in the first cost: the first point under the level is the best.
    const auto best = std::find_if(out_.front.begin(), out_.front.end(), [&level](const ParetoPoint& p) {
      for (std::size_t c = 0; c < p.costs.size(); ++c) {
        if (p.costs[c] > level->levels[c]) return false;
      }
      return true;
    });
    level->best = static_cast<std::size_t>(best - out_.front.begin());
    level = best == out_.front.end() ? out_.levels.erase(level) : level + 1;
  }
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

bool verify(const Study& study, const Objective& objective, const ParetoOptions& options,
            ParetoResult& result, Workers& workers, const std::atomic<bool>& stop) {
  std::vector<std::vector<double>> points;
  points.reserve(result.front.size());
  for (const ParetoPoint& point : result.front) points.push_back(point.e.x);
  auto fresh = simulate_points(study, points, workers, stop, {});
  if (!fresh) return false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Evaluation& e = (*fresh)[i];
    objective.judge(e);
    Costs costs;
    for (const Criterion& criterion : options.criteria) costs.push_back(cost(criterion, e, study.scenarios));
    if (costs != result.front[i].costs || !e.feasible) {
      throw std::runtime_error(fmt::format("evaluation {} simulated again gives {} {} instead of {}",
                                           result.front[i].evaluation, options.criteria.front().name(),
                                           costs.front(), result.front[i].costs.front()));
    }
    result.front[i].e = std::move(e);
  }
  return true;
}

}  // namespace armtune
