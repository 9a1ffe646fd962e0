#pragma once
// Searches for better gains. It evaluates the start gains, then a coarse sweep, then a global search if the
// study has one, then local searches from one or more points. If the study searches in armtune's own dynamics
// (the native engine), Simbody still simulates the start gains first, and evaluates and refines the result.

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
  /// Called once, when the start gains were simulated and the objective is known.
  std::function<void(const Objective&)> begin;
  /// Called for every evaluation, in order, also for those recalled from a journal. One call at a time, from
  /// any thread. `phase` is one of these:
  ///   - start, sweep, global, search;
  ///   - warm: the point where a warm start begins;
  ///   - gradient: points from which a search forms derivatives;
  ///   - verify: after a search in another engine, the best gains in Simbody. Also points between the start
  ///     gains and the best gains, if `fault` finds a fault in the best.
  std::function<void(const char* phase, const Evaluation&)> evaluated;
  std::function<void(const TuneProgress&)> progress;  ///< called like `evaluated`
  /// Checks gains in ways that take too long for every evaluation, and returns the fault that it finds, or an
  /// empty text. No function: there are no such checks. See TuneResult::best.
  std::function<std::string(const Gains&)> fault;
};

/// Fractions of the way from the start gains to the best gains. If the best gains have a fault, gains at
/// these points are tried instead.
inline constexpr std::array kSharesOfTheWay = {0.5, 0.25, 0.1};

struct TuneResult {
  Evaluation start;
  std::optional<Evaluation> best_of_sweep;  ///< as simulated by Simbody
  /// The best evaluation; feasible if any feasible point was seen. It was simulated in Simbody, unless the
  /// run was interrupted while it searched in another engine; its `engine` shows which. If it has a fault
  /// (TuneCallbacks::fault), points between the start gains and the best gains are tried (kSharesOfTheWay).
  /// The first of them that has no fault, is feasible and is better than the start takes its place. Without
  /// such a point, it remains the best in spite of its fault.
  Evaluation best;
  long evaluations = 0;
  bool interrupted = false;
  std::string reason;       ///< why the search ended
  std::string passed_over;  ///< if `best` lies between start and best gains: what it replaces, why
};

/// Runs the search of the study. The result depends on the study alone, unless max_minutes is set. `stop`:
/// set from outside to end the run; the rollouts that are running are then dropped. journal: evaluations are
/// recorded in it and, if the run is resumed, read from it. Throws InputError if the start gains give no
/// reference for the objective.
TuneResult tune(const Study& study, CandidateRunner& workers, const std::atomic<bool>& stop,
                const TuneCallbacks& callbacks, Journal* journal = nullptr);

/// Returns the largest ratio of a joint's |q'| to its limit over an evaluation's scenarios. The rollouts that
/// check stability margins are left out.
double largest_velocity_ratio(const Study& study, const Evaluation& e);

}  // namespace armtune::internal
