#pragma once
// The tuning loop: start gains, coarse sweep, search: global if the study says so, then local from one or
// more points. Where the study searches in the native engine, Simbody has the first and the last word.

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
};

struct TuneResult {
  Evaluation start;
  std::optional<Evaluation> best_of_sweep;  ///< as Simbody sees it
  /// Feasible if any feasible point was seen. Simbody's, but for an interrupted run that searched in another
  /// engine: see its `engine`.
  Evaluation best;
  long evaluations = 0;
  bool interrupted = false;
  std::string reason;  ///< why the search ended
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
