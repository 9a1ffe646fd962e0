#pragma once
// A run that simulates several gain sets over the same scenarios. It is whole or nothing.

#include "tuner/report/scene.hpp"
#include "tuner/rollouts/comparison.hpp"
#include "tuner/session/simulate_session.hpp"

namespace armtune::internal {

struct CompareOutcome {
  Ending ending = Ending::kInterrupted;
  std::vector<ComparedSet> sets;  ///< empty if interrupted before all were simulated: then nothing is written
  std::vector<std::optional<std::vector<EnduranceResult>>> endured;  ///< one for each set
  SimulationVerdict verdict;
  std::vector<std::string> files;  ///< names of those in the folder
};

class CompareSession {
 public:
  /// sets: their names are different, and names of files where there is a folder. The observer outlives the
  /// session.
  CompareSession(RolloutSettings settings, std::vector<GainsToSimulate> sets, SessionContext context,
                 SessionObserver& observer);

  /// Runs it; may be called once. Throws as SimulateSession::run does.
  CompareOutcome run();

 private:
  std::string recordings_of(const std::string& set) const;
  bool simulate_sets();
  void check();
  void write_files() const;
  void write_conclusion();
  report::Scene scene() const;

  RolloutSettings settings_;
  std::vector<GainsToSimulate> sets_;
  SessionContext context_;
  SessionObserver& observer_;
  CompareOutcome outcome_;
};

}  // namespace armtune::internal
