#pragma once
// Makes the evaluations of a run, one after the other. Those that its journal holds are recalled; all further
// ones come from rollouts.

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

  /// Makes the next evaluations of the run, simulated but not judged. Each is written to the journal as
  /// soon as it is finished, whatever becomes of the others. Each is passed to `take_in` as soon as all
  /// before it are: in order, one call at a time, from any thread. False if `stop` became true before all
  /// were done; of the finished ones, those before the first gap have then been taken in. If the study's
  /// minutes are over before the last candidate is started, the rest is left out. Throws InputError if the
  /// journal has another point at that place than the search now requests.
  bool next(const std::vector<Candidate>& candidates, const Conditions& conditions, const TakeIn& take_in);

  /// True if the run was stopped from outside and nothing is left to recall. A resumed run thus gets at least
  /// as far as it was before.
  bool stopped() const { return stop_ && !recalls(count_); }

  /// Sets whose minutes count from here on: they are over `kept` [s] before the study's max_minutes are. A
  /// search keeps time for what has to follow it; the run itself keeps none. At first they are the run's.
  void use(Minutes minutes, double kept = 0.0);

  /// False once the minutes are over. In a resumed run they are over where they were before, and the time
  /// before the interruption counts.
  bool time_left();
  /// True if they were over at the last call of time_left().
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
