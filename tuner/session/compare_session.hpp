#pragma once
// The work of the command `armtune compare`. It simulates several gain sets in the same scenarios and
// compares them. If it is interrupted before all sets were simulated, it leaves no result.

#include "tuner/report/scene.hpp"
#include "tuner/rollouts/comparison.hpp"
#include "tuner/session/simulate_session.hpp"

namespace armtune::internal {

struct CompareOutcome {
  Ending ending = Ending::kInterrupted;
  std::vector<ComparedSet> sets;  ///< empty if interrupted before all were simulated; no file is written then
  std::vector<std::optional<std::vector<EnduranceResult>>> endured;  ///< one per set; nullopt: not extended
  SimulationVerdict verdict;
  std::vector<std::string> files;  ///< names of the files in the folder
};

class CompareSession {
 public:
  /// sets: their names differ from each other, and are valid file names if the session has a folder. The
  /// observer must outlive the session.
  CompareSession(RolloutSettings settings, std::vector<GainsToSimulate> sets, SessionContext context,
                 SessionObserver& observer);

  /// Runs the session; may be called once. Throws the same errors as SimulateSession::run.
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
