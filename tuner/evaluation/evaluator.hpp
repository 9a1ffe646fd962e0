#pragma once
// Makes the evaluations that a search requests. A resumed run does not repeat the evaluations that it
// finished before the interruption, but reads them from its journal. It simulates all further evaluations,
// and writes them to the journal.

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <vector>

#include "tuner/journal/journal.hpp"
#include "tuner/study/study.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune::internal {

/// A point to simulate, and the phase of the search that needs it.
struct Candidate {
  const char* phase = "";
  std::vector<double> x;
};

class Evaluator {
 public:
  /// journal: may be null; then nothing is recorded or recalled.
  Evaluator(const Study& study, CandidateRunner& workers, const std::atomic<bool>& stop, Journal* journal);

  using TakeIn = std::function<void(const char* phase, Evaluation e)>;

  /// Makes the next evaluations of the run. Their objective and constraints are not computed yet. Each
  /// evaluation is written to the journal as soon as it is finished, even if an earlier one is not.
  /// `take_in` receives the evaluations in the order of the candidates, one call at a time, from any thread.
  /// Each is passed on as soon as it and all earlier evaluations are finished. Returns false if `stop`
  /// became true before all were done; `take_in` has then received the evaluations before the first
  /// unfinished one. If the time budget is used up, candidates that have not been started are left out, and
  /// the result is true. Throws InputError if the journal's evaluation with the same number is not the one
  /// that the search requests.
  bool next(const std::vector<Candidate>& candidates, const Conditions& conditions, const TakeIn& take_in);

  /// True if the run was stopped from outside and the journal has no further evaluation. A resumed run
  /// therefore stops only after it has read every evaluation in the journal.
  bool stopped() const { return stop_ && !recalls(count_); }

  /// Sets the time budget that applies from now on. It ends `kept` [s] before the study's max_minutes are
  /// over, so that a search leaves time for the steps after it. Before the first call the budget is that of
  /// the whole run, with no time reserved.
  void use(Minutes minutes, double kept = 0.0);

  /// True if the time budget is not used up. In a resumed run the budget ends at the same evaluation as
  /// before, and the time before the interruption counts.
  bool time_left();
  /// True if the last call of time_left() returned false.
  bool time_was_up() const { return time_was_up_; }

 private:
  bool next_portion(const std::vector<Candidate>& candidates, const Conditions& conditions,
                    const TakeIn& take_in);
  /// Returns the number of evaluations to start before the time is checked again.
  std::size_t portion() const;
  bool is_time_up();
  double seconds() const;
  bool recalls(std::uint64_t number) const { return journal_ != nullptr && journal_->find(number); }
  std::optional<Evaluation> recall(std::uint64_t number, const Candidate& candidate, Engine engine) const;

  const Study& study_;
  CandidateRunner& workers_;
  const std::atomic<bool>& stop_;
  Journal* journal_;
  std::uint64_t count_ = 0;  ///< number of evaluations so far
  Minutes minutes_ = Minutes::kRun;
  double kept_ = 0.0;  ///< [s]
  bool time_was_up_ = false;
  std::chrono::steady_clock::time_point began_;
};

}  // namespace armtune::internal
