#pragma once
// The evaluations of a run, one after the other: from its journal as far as it goes, from rollouts beyond.

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <vector>

#include "tuner/journal/journal.hpp"
#include "tuner/study/study.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune::internal {

/// A point to simulate, and what for.
struct Candidate {
  const char* phase = "";
  std::vector<double> x;
};

class Evaluator {
 public:
  /// journal: may be null, then nothing is recorded or recalled.
  Evaluator(const Study& study, CandidateRunner& workers, const std::atomic<bool>& stop, Journal* journal);

  using TakeIn = std::function<void(const char* phase, Evaluation e)>;

  /// The next evaluations of the run, simulated but not judged. Each goes to the journal as soon as it is
  /// finished, whatever becomes of the others, and to `take_in` as soon as all before it are: in order, one
  /// call at a time, from any thread. False if `stop` became true before all were done; of those that were,
  /// the first without a gap have been taken in. Where the study's minutes are over before the last of them
  /// is begun, the rest is left out. Throws InputError if the journal holds another point at that place than
  /// the search now asks for.
  bool next(const std::vector<Candidate>& candidates, const Conditions& conditions, const TakeIn& take_in);

  /// True once the run was asked to stop and nothing is left to recall: a resumed run comes at least to
  /// where it was before.
  bool stopped() const { return stop_ && !recalls(count_); }

  /// From here on minutes are over `kept` [s] before the study's max_minutes are: a search's, for what has to
  /// follow it; the run's with nothing kept. At first they are the run's.
  void use(Minutes minutes, double kept = 0.0);

  /// False once the minutes are over. A resumed run takes them to be over where they were before, and
  /// counts its minutes on.
  bool time_left();
  /// Whether they were over when they were looked at last.
  bool time_was_up() const { return time_was_up_; }

 private:
  bool next_portion(const std::vector<Candidate>& candidates, const Conditions& conditions,
                    const TakeIn& take_in);
  /// Evaluations to begin before time is looked at again.
  std::size_t portion() const;
  bool is_time_up();
  double seconds() const;
  bool recalls(std::uint64_t number) const { return journal_ != nullptr && journal_->find(number); }
  std::optional<Evaluation> recall(std::uint64_t number, const Candidate& candidate, Engine engine) const;

  const Study& study_;
  CandidateRunner& workers_;
  const std::atomic<bool>& stop_;
  Journal* journal_;
  std::uint64_t count_ = 0;  ///< given out so far
  Minutes minutes_ = Minutes::kRun;
  double kept_ = 0.0;  ///< [s]
  bool time_was_up_ = false;
  std::chrono::steady_clock::time_point began_;
};

}  // namespace armtune::internal
