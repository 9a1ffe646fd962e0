#pragma once
// Finds the Pareto front of a study, which shows how much one criterion gets worse when another one improves.
//
// It uses the epsilon-constraint method (Haimes, Lasdon, Wismer, 1971). It minimises the first criterion
// while the others must not exceed a level, level by level, there and back. Each search begins at the best
// point known for its level, which is mostly that of a neighbour. The front contains the feasible evaluations
// of the whole run that no other one dominates, whatever search made them.

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
  std::vector<Criterion> criteria;  ///< two or three; the first is minimised, the others get levels
  std::size_t levels = 12;          ///< number for each of the others, including both ends (>= 2)
  long max_evaluations = 1200;

  /// Returns the number of searches for all levels, there and back.
  std::size_t searches() const;
};

struct ParetoPoint {
  long evaluation = 0;  ///< number of the evaluation in the journal
  Evaluation e;
  Costs costs;  ///< one per criterion; less is better
};

/// A level of the other criteria, with the best first criterion that was found below it.
struct ParetoLevel {
  Costs levels;
  std::size_t best = 0;  ///< index into ParetoResult::front
};

struct ParetoResult {
  ParetoPoint start;
  std::vector<ParetoPoint> front;  ///< feasible and not dominated, ascending in the first cost
  std::vector<ParetoLevel> levels;
  double hypervolume = 0.0;  ///< volume below the start's costs (see front.hpp)
  long evaluations = 0;
  bool interrupted = false;
  bool out_of_time = false;  ///< true if the study's minutes ended before the searches did
  std::exception_ptr
      failure;  ///< error that ended the search early, such as a full disk; the rest is what was found before

  /// Returns the number of points of the front that dominate the start.
  std::size_t dominating_start() const;
};

struct ParetoProgress {
  std::string phase;
  long evaluations = 0;
  long max_evaluations = 0;
  std::size_t front = 0;  ///< number of points so far
};

struct ParetoCallbacks {
  /// Called once, when the start gains were simulated.
  std::function<void(const Objective&)> begin;
  /// Called for every evaluation in order, also for those from a journal; one call at a time, from any
  /// thread. phase: start, warm, anchor, level or gradient.
  std::function<void(const char* phase, const Evaluation&)> evaluated;
  std::function<void(const ParetoProgress&)> progress;
};

/// Finds the front. The result is deterministic: it depends only on study and options, unless the study sets
/// max_minutes. One end of the front is the least of the first criterion. The others are the least of each
/// other criterion with none of the rest worse than at the start, if feasible points are that good. Throws
/// InputError if the start gains give no reference for the objective or a criterion. journal: as in tune().
ParetoResult pareto(const Study& study, const ParetoOptions& options, CandidateRunner& workers,
                    const std::atomic<bool>& stop, const ParetoCallbacks& callbacks,
                    Journal* journal = nullptr);

/// Computes the front, the hypervolume and the best point of each level from feasible points. Keeps the start
/// and the levels.
void settle(ParetoResult& result, const std::vector<ParetoPoint>& points);

/// Simulates the front again in Simbody, with `workers` that did not search, and replaces the results. Throws
/// FailedError if a result differs from the search's: at all if the search used Simbody too, else by more
/// than a small tolerance. Points that another engine found are judged again and may leave the front. Returns
/// false if `stop` became true before it ended.
bool verify(const Study& study, const Objective& objective, const ParetoOptions& options,
            ParetoResult& result, CandidateRunner& workers, const std::atomic<bool>& stop);

}  // namespace armtune::internal
