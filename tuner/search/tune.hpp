#pragma once
// The tuning loop: start gains, coarse sweep, search: global if the study says so, then local from one or
// more points. Where the study searches in the native engine, Simbody has the first and the last word.

#include <array>
#include <atomic>
#include <functional>
#include <optional>

#include "tuner/journal/journal.hpp"
#include "tuner/study/study.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune::internal {

struct TuneProgress {
  const char* phase = "";
  long evaluations = 0;
  long max_evaluations = 0;
  const Evaluation* last = nullptr;
  const Evaluation* best = nullptr;
};

struct TuneCallbacks {
  /// Once, when the start gains were simulated and the objective stands.
  std::function<void(const Objective&)> begin;
  /// For every evaluation, in order, those recalled from a journal too; one call at a time, from any thread.
  /// `phase`: start, sweep, warm (where a warm start begins), global, search, gradient (points that either
  /// of the two forms derivatives with), or verify (Simbody after another engine).
  std::function<void(const char* phase, const Evaluation&)> evaluated;
  std::function<void(const TuneProgress&)> progress;  ///< as `evaluated`
  /// What checks that are too long for every evaluation find wrong with gains; empty text: nothing. No
  /// function: there are none. See TuneResult::best.
  std::function<std::string(const Gains&)> fault;
};

/// Where the best has a fault, how far from the start towards it gains are tried that may have none.
inline constexpr std::array kSharesOfTheWay = {0.5, 0.25, 0.1};

struct TuneResult {
  Evaluation start;
  std::optional<Evaluation> best_of_sweep;  ///< as Simbody sees it
  /// Feasible if any feasible point was seen. Simbody's, but for an interrupted run that searched in another
  /// engine: see its `engine`. Where it has a fault (TuneCallbacks), the first of up to three points on the
  /// way back to the start that has none, is feasible and better than the start; without such a point still
  /// the best.
  Evaluation best;
  long evaluations = 0;
  bool interrupted = false;
  std::string reason;       ///< why the search ended
  std::string passed_over;  ///< of a result on the way back: what it takes the place of, and why
};

/// Runs the study. `stop`: set from outside to end after the rollouts under way are dropped. Deterministic:
/// a function of the study alone, unless max_minutes is set. journal: where evaluations are recorded and, if
/// the run is resumed, recalled from. Throws InputError if the start gains give no
/// reference.
TuneResult tune(const Study& study, CandidateRunner& workers, const std::atomic<bool>& stop,
                const TuneCallbacks& callbacks, Journal* journal = nullptr);

/// Largest |q'|/limit over an evaluation's scenarios, the corners of margins aside.
double largest_velocity_ratio(const Study& study, const Evaluation& e);

}  // namespace armtune::internal
