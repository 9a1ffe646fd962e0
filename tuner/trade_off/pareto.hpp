#pragma once
// Finds the Pareto front of a study (`armtune pareto`). The front shows how much one criterion gets worse
// when another one improves.
//
// The method is the epsilon-constraint method (Haimes, Lasdon, Wismer, 1971). A level is a set of upper
// limits on all criteria except the first (level_grid.hpp). For each level, a search minimises the first
// criterion under these limits. It starts from the best known point that satisfies them, which usually comes
// from a neighbouring level. All levels are searched once in order, and once in reverse order. The front
// contains all feasible evaluations of the run that no other one dominates (front.hpp).

#include <atomic>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "tuner/journal/journal.hpp"
#include "tuner/study/study.hpp"
#include "tuner/trade_off/criterion.hpp"
#include "tuner/trade_off/front.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune::internal {

struct ParetoOptions {
  std::vector<Criterion> criteria;  ///< two or three; the first is minimised, the others get limits
  std::size_t levels = 12;          ///< number of limits for each criterion but the first (>= 2)
  long max_evaluations = 1200;

  /// Returns the number of searches: two for every level.
  std::size_t searches() const;
};

struct ParetoPoint {
  long evaluation = 0;  ///< number of the evaluation in the journal
  Evaluation e;
  Costs costs;  ///< one per criterion; less is better
};

/// A level, and the best point that was found for it.
struct ParetoLevel {
  Costs levels;          ///< upper limits, one per criterion; that of the first is infinite
  std::size_t best = 0;  ///< index into the front: point within the limits with the smallest first cost
};

struct ParetoResult {
  ParetoPoint start;
  std::vector<ParetoPoint> front;  ///< feasible and not dominated, ascending in the first cost
  std::vector<ParetoLevel> levels;
  double hypervolume = 0.0;  ///< hypervolume (front.hpp) with the costs of the start gains as reference
  long evaluations = 0;
  bool interrupted = false;
  bool out_of_time = false;  ///< true if the study's max_minutes ended the searches
  std::exception_ptr
      failure;  ///< error that ended the search early, such as a full disk; earlier results are kept

  /// Returns the number of points of the front that dominate the start gains.
  std::size_t dominating_start() const;
};

struct ParetoProgress {
  std::string phase;
  long evaluations = 0;
  long max_evaluations = 0;
  std::size_t front = 0;  ///< number of points of the front so far
};

struct ParetoCallbacks {
  /// Called once, after the start gains were simulated.
  std::function<void(const Objective&)> begin;
  /// Called for every evaluation in order, also for those from a journal; one call at a time, from any
  /// thread. phase: start, warm, anchor, level or gradient.
  std::function<void(const char* phase, const Evaluation&)> evaluated;
  std::function<void(const ParetoProgress&)> progress;
};

/// Finds the front. The result is deterministic: it depends only on study and options, unless the study sets
/// max_minutes. The search first finds the ends of the front. One end is the minimum of the first criterion.
/// For each other criterion, the end is its minimum while the remaining criteria are no worse than with the
/// start gains. If no known feasible point satisfies such a limit, the limit is left out. Throws InputError
/// if the start gains give no reference for the objective or for a criterion. journal: as in tune().
ParetoResult pareto(const Study& study, const ParetoOptions& options, CandidateRunner& workers,
                    const std::atomic<bool>& stop, const ParetoCallbacks& callbacks,
                    Journal* journal = nullptr);

/// Sets the front, the hypervolume and the best point of each level of `result`, computed from feasible
/// points. Levels whose limits no point satisfies are removed. `result.start` is not changed.
void settle(ParetoResult& result, const std::vector<ParetoPoint>& points);

/// Simulates all points of the front again in Simbody (the dynamics library with which results are verified),
/// and replaces the results. `workers` must not have been used in the search. If the search used Simbody,
/// throws FailedError if any cost differs from that of the search, or if a point is no longer feasible. If
/// the search used another engine, throws FailedError only if a cost differs by more than a small tolerance.
/// Points that are then infeasible or dominated are removed from the front. Returns false if `stop` became
/// true before all points were simulated.
bool verify(const Study& study, const Objective& objective, const ParetoOptions& options,
            ParetoResult& result, CandidateRunner& workers, const std::atomic<bool>& stop);

}  // namespace armtune::internal
