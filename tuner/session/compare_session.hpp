#pragma once
// The work of the command `armtune compare`. It simulates several gain sets in the same scenarios and
// compares their metrics. If it is interrupted before all gain sets were simulated, there is no result.

#include "tuner/report/scene.hpp"
#include "tuner/rollouts/comparison.hpp"
#include "tuner/session/simulate_session.hpp"

namespace armtune::internal {

struct CompareOutcome {
  Ending ending = Ending::kInterrupted;
  std::vector<ComparedSet> sets;  ///< empty, and no file is written, if interrupted before all were simulated
  /// Results of the scenarios extended to many minutes, one entry per gain set; none if not extended.
  std::vector<std::optional<std::vector<EnduranceResult>>> endured;
  SimulationVerdict verdict;
  std::vector<std::string> files;  ///< names of the files in the folder
};

class CompareSession {
 public:
  /// sets: no two have the same name. If the session has a folder, the names must be valid file names. The
  /// observer must outlive the session.
  CompareSession(RolloutSettings settings, std::vector<GainsToSimulate> sets, SessionContext context,
                 SessionObserver& observer);

  /// Runs the session. May be called only once. Throws the same errors as SimulateSession::run.
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
