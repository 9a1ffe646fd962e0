#include "tuner/trade_off/pareto.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armtune/error.hpp"
#include "tuner/trade_off/aimed_search.hpp"
#include "tuner/trade_off/level_grid.hpp"

namespace armtune::internal {
namespace {

/// Shares of the budget for minimising the first criterion, and for minimising each other criterion.
constexpr double kFirstAnchorShare = 0.25;
constexpr double kAnchorShare = 0.08;
/// Initial step of the search for a level, relative to the study's. It is short, because the search starts
/// from the solution of a neighbouring level.
constexpr double kLevelStep = 0.4;
/// COBYLA suits a short search from a neighbour. Its linear models need n + 1 points, where quadratic models
/// need 2 n + 1, and it handles constraints itself.
constexpr const char* kLevelAlgorithm = "COBYLA";

/// Makes the searches for a front: first for its ends (anchors), then for the levels between them.
class Front {
 public:
  Front(const Study& study, const ParetoOptions& options, AimedSearch& search)
      : study_(study), options_(options), search_(search) {}

  void anchors();
  void levels();
  /// Returns all levels, or none before they were searched. Their `best` is not set.
  const std::vector<ParetoLevel>& found() const { return found_; }

 private:
  Costs held_for(std::size_t k) const;
  Aim level(const std::vector<std::size_t>& digits, long budget) const;
  Costs free_levels() const { return Costs(options_.criteria.size(), HUGE_VAL); }

  const Study& study_;
  const ParetoOptions& options_;
  AimedSearch& search_;
  std::vector<Costs> axes_;  ///< levels along each criterion but the first
  std::vector<ParetoLevel> found_;
};

/// Returns the upper limits of the other criteria for the minimisation of criterion k. There are none for the
/// first criterion. Otherwise, the limit of a criterion is the start's cost, but only if a known feasible
/// point is as good. A start that violates constraints may be better than all feasible points.
Costs Front::held_for(std::size_t k) const {
  Costs held = free_levels();
  if (k == 0) return held;
  for (std::size_t c = 0; c < held.size(); ++c) {
    if (c == k) continue;
    const ParetoPoint* least = search_.archive().best_under(c, free_levels());
    if (least && least->costs[c] <= search_.so_far().start.costs[c])
      held[c] = search_.so_far().start.costs[c];
  }
  return held;
}

void Front::anchors() {
  const auto budget = static_cast<double>(options_.max_evaluations);
  for (std::size_t k = 0; k < options_.criteria.size(); ++k) {
    const Costs held = held_for(k);
    const std::string shown = "least " + options_.criteria[k].name();
    SolverOptions solver = solver_of(study_);
    double share = kAnchorShare;
    if (k > 0) {
      solver.algorithm = kLevelAlgorithm;
      solver.constraints = ConstraintHandling::kAuto;
    } else {
      share = kFirstAnchorShare;
      if (const std::string algorithm = global_of(study_); !algorithm.empty()) {
        SolverOptions global = solver;
        global.algorithm = algorithm;
        const double part = study_.global_share * share;
        search_.minimise("anchor", shown,
                         {{k, held, search_.so_far().start.e.x, static_cast<long>(part * budget), global}});
        share -= part;
      }
    }
    const ParetoPoint* best = search_.archive().best_under(k, held);
    search_.minimise(
        "anchor", shown,
        {{k, held, best ? best->e.x : search_.best().x, static_cast<long>(share * budget), solver}});
  }
}

/// Returns the aim of a level. digits[i]: number of steps along criterion i + 1.
Aim Front::level(const std::vector<std::size_t>& digits, long budget) const {
  Aim aim;
  aim.levels = free_levels();
  for (std::size_t a = 0; a < axes_.size(); ++a) aim.levels[a + 1] = axes_[a][digits[a]];
  aim.x = search_.archive().beginning(aim.levels, search_.so_far().start);
  aim.budget = budget;
  aim.solver = solver_of(study_);
  aim.solver.algorithm = kLevelAlgorithm;
  aim.solver.constraints = ConstraintHandling::kAuto;
  aim.solver.initial_step *= kLevelStep;
  return aim;
}

void Front::levels() {
  const ParetoPoint* top = search_.archive().best_under(0, free_levels());
  if (search_.so_far().interrupted || !top) return;
  // The levels of each other criterion go from its cost where the first criterion is least to its own least
  // cost.
  const Costs high = top->costs;
  for (std::size_t k = 1; k < high.size(); ++k) {
    const ParetoPoint* least = search_.archive().best_under(k, held_for(k));
    if (!least) least = search_.archive().best_under(k, free_levels());
    const double low = least ? least->costs[k] : high[k];
    Costs& axis = axes_.emplace_back();
    const auto steps = static_cast<double>(options_.levels - 1);
    for (std::size_t i = 0; i < options_.levels; ++i) {
      axis.push_back(std::lerp(high[k], low, static_cast<double>(i) / steps));
    }
  }
  const auto grid = serpentine(axes_.size(), options_.levels);
  // All levels are searched in order, then in reverse order. Thus each search can start from the solutions of
  // the neighbours on either side.
  const auto way = searched_together(grid.size());
  const std::size_t searches = 2 * grid.size();
  std::size_t done = 0;
  for (std::size_t g = 0; g < 2 * way.size() && !search_.so_far().interrupted; ++g) {
    const auto& group = way[g < way.size() ? g : 2 * way.size() - 1 - g];
    std::vector<Aim> aims;
    const long left = options_.max_evaluations - search_.so_far().evaluations;
    const long budget = left / static_cast<long>(searches - done);
    for (const std::size_t place : group) aims.push_back(level(grid[place], budget));
    done += group.size();
    search_.minimise("level", fmt::format("levels {}/{}", done, searches), aims);
  }
  for (const auto& digits : grid) {
    Costs levels = free_levels();
    for (std::size_t a = 0; a < axes_.size(); ++a) levels[a + 1] = axes_[a][digits[a]];
    found_.push_back({levels, 0});
  }
}

}  // namespace

ParetoResult pareto(const Study& study, const ParetoOptions& options, CandidateRunner& workers,
                    const std::atomic<bool>& stop, const ParetoCallbacks& callbacks, Journal* journal) {
  AimedSearch search(study, options, workers, stop, callbacks, journal);
  Front front(study, options, search);
  std::exception_ptr failure;
  try {
    if (search.start()) {
      front.anchors();
      front.levels();
    }
  } catch (const InputError&) {
    throw;
  } catch (...) {
    failure = std::current_exception();
  }
  ParetoResult result = search.so_far();
  result.levels = front.found();
  settle(result, search.archive().points());
  result.failure = failure;
  return result;
}

}  // namespace armtune::internal
