#pragma once
// Searches for better gains (`armtune tune`). First, the start gains and a coarse sweep are evaluated. Then a
// global search follows, if the study has one, and then local searches from one or more points. A final phase
// (final_phase.hpp), if the study has one, improves the best gains. If the study searches in armtune's own
// dynamics (the native engine), Simbody still simulates the start gains first, and evaluates and refines the
// result.

#include <array>
#include <atomic>
#include <functional>
#include <optional>

#include "tuner/journal/journal.hpp"
#include "tuner/run/search_end.hpp"
#include "tuner/study/study.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune::internal {

struct TuneProgress {
  const char* phase = "";
  long evaluations = 0;  ///< perturbed copies (TuneResult::copies) included
  long max_evaluations = 0;
  const Evaluation* last = nullptr;
  const Evaluation* best = nullptr;
};

struct TuneCallbacks {
  /// Called once, after the start gains were simulated, when the objective is known.
  std::function<void(const Objective&)> begin;
  /// Called for every evaluation, in order, also for those recalled from a journal. One call at a time, from
  /// any thread. `phase` is one of these:
  ///   - start, sweep, global, search, final;
  ///   - warm: the point where a warm start begins;
  ///   - gradient: points for the finite differences of a search;
  ///   - verify: the best gains of a search in another engine, simulated in Simbody; also points between the
  ///     start gains and the best gains, if `fault` finds a fault in the best gains.
  std::function<void(const char* phase, const Evaluation&)> evaluated;
  std::function<void(const TuneProgress&)> progress;  ///< called like `evaluated`
  /// Checks gains in ways that take too long to be used for every evaluation. Returns the fault that it
  /// finds, or an empty text. If the function is empty, no such checks are made. See TuneResult::best.
  std::function<std::string(const Gains&)> fault;
};

/// Fractions of the way from the start gains to the best gains. If the best gains have a fault, gains at
/// these points are tried instead.
inline constexpr std::array kSharesOfTheWay = {0.5, 0.25, 0.1};

struct TuneResult {
  Evaluation start;
  std::optional<Evaluation> best_of_sweep;  ///< as simulated by Simbody
  /// The best evaluation. It is feasible if any feasible point was seen. It was simulated in Simbody, unless
  /// the run was interrupted while it searched in another engine; `best.engine` shows which. If the best
  /// gains have a fault (TuneCallbacks::fault), points between the start gains and these gains are tried
  /// (kSharesOfTheWay). The first of these points that has no fault, is feasible and is better than the start
  /// gains becomes the best. If there is none, the gains with the fault remain the best.
  Evaluation best;
  long evaluations = 0;
  /// Number of gain sets that were simulated for derivatives only (final_phase.hpp). Each counts as one of
  /// the study's evaluations. `evaluations` does not contain them.
  long copies = 0;
  bool interrupted = false;
  SearchEnd ended = SearchEnd::kConverged;  ///< why the search ended
  std::string reason;                       ///< the same in words
  std::string passed_over;  ///< why `best` replaces better gains that have a fault; empty: it does not
};

/// Runs the search of the study. The result depends on the study alone, unless max_minutes is set. stop: set
/// from outside to end the run; rollouts (simulations) that are running are then discarded. journal: file in
/// which evaluations are recorded, and from which a resumed run reads them. Throws InputError if the start
/// gains give no reference for the objective.
TuneResult tune(const Study& study, CandidateRunner& workers, const std::atomic<bool>& stop,
                const TuneCallbacks& callbacks, Journal* journal = nullptr);

/// Returns the largest ratio of a joint's |q'| to its limit over an evaluation's scenarios. The rollouts that
/// check stability margins are left out.
double largest_velocity_ratio(const Study& study, const Evaluation& e);

}  // namespace armtune::internal
