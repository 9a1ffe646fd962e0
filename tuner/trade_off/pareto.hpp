#pragma once
// The front of a study: what less of one criterion costs in another.
//
// Epsilon-constraint method (Haimes, Lasdon, Wismer, 1971): the first criterion is minimised while the others
// must not exceed a level, level by level and back again, each search from the best point known for it,
// mostly its neighbour's. The front is what no other evaluation of the whole run dominates, whatever it was
// made for.

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
  std::vector<Criterion> criteria;  ///< two or three; the first is searched, the others get levels
  std::size_t levels = 12;          ///< searches along each of the others, its two ends included (>= 2)
  long max_evaluations = 1200;

  /// How many searches the levels make: there and back.
  std::size_t searches() const;
};

struct ParetoPoint {
  long evaluation = 0;  ///< its number in the journal
  Evaluation e;
  Costs costs;  ///< of the criteria: less is better
};

/// A level of the others, and the best first criterion that was found under it.
struct ParetoLevel {
  Costs levels;
  std::size_t best = 0;  ///< index into ParetoResult::front
};

struct ParetoResult {
  ParetoPoint start;
  std::vector<ParetoPoint> front;  ///< feasible points that no other dominates, ascending in the first cost
  std::vector<ParetoLevel> levels;
  double hypervolume = 0.0;  ///< below the start (see front.hpp)
  long evaluations = 0;
  bool interrupted = false;
  bool out_of_time = false;  ///< the study's minutes were used up before the searches were through
  std::exception_ptr
      failure;  ///< what ended the search early, such as a full disk; the rest is what it had found

  /// The front's points that dominate the start.
  std::size_t dominating_start() const;
};

struct ParetoProgress {
  std::string phase;
  long evaluations = 0;
  long max_evaluations = 0;
  std::size_t front = 0;  ///< points so far
};

struct ParetoCallbacks {
  /// Once, when the start gains were simulated.
  std::function<void(const Objective&)> begin;
  /// For every evaluation, in order, those recalled from a journal too; one call at a time, from any thread.
  /// `phase`: start, warm, anchor, level or gradient.
  std::function<void(const char* phase, const Evaluation&)> evaluated;
  std::function<void(const ParetoProgress&)> progress;
};

/// Deterministic: a function of study and options alone, unless the study sets max_minutes. The front's ends:
/// the least of the first criterion, and the least of each other one with none of the rest worse than the
/// start's (as far as feasible points are that good). Throws InputError if the start gains give no reference
/// for the objective or a criterion. journal: as of tune().
ParetoResult pareto(const Study& study, const ParetoOptions& options, CandidateRunner& workers,
                    const std::atomic<bool>& stop, const ParetoCallbacks& callbacks,
                    Journal* journal = nullptr);

/// Makes front, hypervolume and the levels' best from feasible points; the start and the levels stand.
void settle(ParetoResult& result, const std::vector<ParetoPoint>& points);

/// Simulates the front again, in Simbody and in `workers` of its own, and takes those results in. Throws
/// FailedError if one differs from what the search saw: to the bit if that was Simbody too. What
/// another engine found is judged anew: it may leave the front. False if `stop` became true before.
bool verify(const Study& study, const Objective& objective, const ParetoOptions& options,
            ParetoResult& result, CandidateRunner& workers, const std::atomic<bool>& stop);

}  // namespace armtune::internal
