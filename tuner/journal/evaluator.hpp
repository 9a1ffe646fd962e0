#pragma once
// The evaluations of a run, one after the other: from its journal as far as it goes, from rollouts beyond.

#include <atomic>
#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "tuner/journal/journal.hpp"
#include "tuner/study/study.hpp"
#include "tuner/work/workers.hpp"

namespace armtune {

class Evaluator {
 public:
  /// journal: may be null, then nothing is recorded or recalled.
  Evaluator(const Study& study, Workers& workers, const std::atomic<bool>& stop, Journal* journal);

  /// The next points of the run, in order, simulated but not judged. Each is in the journal as soon as it is
  /// finished, whatever becomes of the others. limits: per scenario, where rollouts end before their time; empty:
  /// nowhere. Nothing if `stop` became true before all were. Throws
  /// InputError if the journal holds another point at that place than the search now asks for.
  std::optional<std::vector<Evaluation>> next(const std::string& phase,
                                              const std::vector<std::vector<double>>& points,
                                              const std::vector<EndLimits>& limits);

  /// False once the study's max_minutes are over. A run that goes on takes them to be over where they were
  /// before, and counts its minutes on.
  bool time_left();

 private:
  double seconds() const;
  std::optional<Evaluation> recall(std::uint64_t number, const std::string& phase,
                                   const std::vector<double>& x) const;

  const Study& study_;
  Workers& workers_;
  const std::atomic<bool>& stop_;
  Journal* journal_;
  std::uint64_t count_ = 0;  ///< given out so far
  std::chrono::steady_clock::time_point began_;
};

}  // namespace armtune
