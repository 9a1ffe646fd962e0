#pragma once
// Candidates that are given up before all their rollouts are done, because they cannot make any difference.

#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "sim/rollout/rollout.hpp"

namespace armtune {

/// How it shows that a candidate costs more than a bar.
struct Outdone {
  /// Where a rollout of a scenario ends, by those of its candidate that are finished: one place per scenario.
  std::function<EndCost(std::size_t scenario, const std::vector<std::optional<RolloutResult>>& finished,
                        double bar)>
      end;
  /// Whether a candidate is above its bar, by the results of all its scenarios. Must be true of whatever
  /// ended by `end`, had it gone on.
  std::function<bool(const std::vector<RolloutResult>& results, double bar)> above;
};

/// Candidates under way. Where the first rollout ends that shows it depends on which are finished by then;
/// so a candidate above its bar has no results at all, even if it was simulated whole. For one arm each.
class UnderBars {
 public:
  /// bars: one per candidate, HUGE_VAL where it is to be simulated whole; or empty.
  UnderBars(const std::optional<Outdone>& outdone, const std::vector<double>& bars, std::size_t scenarios);

  /// Where the candidate's rollout of a scenario ends. From any thread.
  EndCost cost(std::size_t candidate, std::size_t scenario) const;
  /// A rollout is done. From any thread.
  void note(std::size_t candidate, std::size_t scenario, const RolloutResult& result);
  /// All are done. results: one per scenario, taken away if it is above its bar.
  void settle(std::size_t candidate, std::vector<RolloutResult>& results);

 private:
  const std::optional<Outdone>& outdone_;
  const std::vector<double>& bars_;
  mutable std::mutex mutex_;
  std::vector<std::vector<std::optional<RolloutResult>>> finished_;  ///< [candidate][scenario]

  bool has_bar(std::size_t candidate) const { return !finished_.empty() && !finished_[candidate].empty(); }
};

}  // namespace armtune
