#include "tuner/trade_off/pareto.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armtune/error.hpp"
#include "tuner/trade_off/aimed_search.hpp"
#include "tuner/trade_off/level_grid.hpp"

namespace armtune::internal {
namespace {

/// Share of the budget for the least of the first criterion, and of each other.
constexpr double kFirstAnchorShare = 0.25;
constexpr double kAnchorShare = 0.08;
/// A neighbour is near: the search of a level begins with this part of the study's initial step.
constexpr double kLevelStep = 0.4;
/// Linear models need n + 1 points where quadratic ones need 2 n + 1, and constraints stay constraints: what
/// a short search from a neighbour wants.
constexpr const char* kLevelAlgorithm = "COBYLA";

/// The aims that make a front: its ends, then the levels between them.
class Front {
 public:
  Front(const Study& study, const ParetoOptions& options, AimedSearch& search)
      : study_(study), options_(options), search_(search) {}

  void anchors();
  void levels();
  /// All levels, once they are searched; without their best.
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

/// What the other criteria must not exceed while criterion k becomes least: the start's, where any feasible
/// point is known to be that good. A start that breaks constraints may be better than all that keep them.
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

/// Digit i of a level counts steps along criterion i + 1.
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
  // From where the first criterion is least (so high the others rise for it) to the least of each other one.
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
  // There and back: what a level finds is its neighbours' beginning, on either side.
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
