#pragma once
// Tries several sets of gains on one task until the arm completes the task with one of them.

#include <optional>
#include <string>
#include <vector>

#include "sim/rollout/rollout.hpp"
#include "sim/scenario/default_task.hpp"
#include "tuner/first_task/first_study.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune::internal {

/// Gains with which the arm completed a task.
struct TriedGains {
  Gains gains;
  Metrics metrics;  ///< of the task with these gains, simulated in Simbody
};

class FirstTrial {
 public:
  /// workers: number of threads (>= 1).
  FirstTrial(const DefaultTask& task, int workers);

  /// Returns the first of the gain sets (first_gain_sets.hpp) that passes all tests of find_first_task, or
  /// nothing.
  std::optional<TriedGains> find();

  /// Returns how the last gain set failed, as a clause.
  const std::string& failed() const { return failed_; }

 private:
  std::optional<Metrics> completed_with(const Gains& gains);
  bool endures(const Gains& gains);
  bool passes(const RolloutResult& result, const char* where);

  Scenario scenario_;
  int workers_;
  std::vector<Gains> gains_;
  CandidateRunner native_;
  FirstDemands demands_;
  std::optional<Rollout> simbody_;
  std::vector<Scenario> other_rotors_;  ///< with a third of the rotor estimate, and three times it
  std::string failed_;
};

}  // namespace armtune::internal
