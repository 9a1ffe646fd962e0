#pragma once
// The work of the command `armtune robustness`. It simulates a gain set on many arms that differ at
// random from the model of the arm. It reports the metrics on each arm, the spread of each metric over the
// arms, and the yield. The yield is the share of arms that keep their limits. If the session has an output
// folder, it writes all files there, and an interrupted run can be resumed.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tuner/report/scene.hpp"
#include "tuner/robustness/monte_carlo.hpp"
#include "tuner/run/append_file.hpp"
#include "tuner/session/journalled_run.hpp"
#include "tuner/verdict/verdict.hpp"
#include "tuner/workers/rank_group.hpp"

namespace armtune::internal {

struct MonteCarloSettings {
  RunPlace place = {};
  std::vector<Scenario> scenarios;
  Gains gains;
  std::string gains_path;     ///< path of the gains file; empty: the gains are from no file
  double deadline = 0.0;      ///< for one rollout, wall clock [s]; 0: derived from its duration
  bool writes_arm = false;    ///< true: if there is one sample only, writes its arm as URDF and robot YAML
  MonteCarloOptions options;  ///< its functions are set by the session
};

struct MonteCarloOutcome {
  Ending ending = Ending::kInterrupted;
  bool was_finished = false;              ///< true if the run had ended before; only `ending` is set then
  std::vector<MonteCarloSample> samples;  ///< in the order of their numbers, up to the first that is missing
  SimulationVerdict verdict;              ///< has no checks if interrupted
  bool recorded = false;                  ///< true if the nominal arm was also simulated, in nominal/
  std::vector<std::string> files;         ///< names of the files in the folder
};

/// An observer of a Monte Carlo session.
class MonteCarloObserver : public SessionObserver {
 public:
  /// Called when a run is resumed. recalled: number of samples that were completed before.
  virtual void resumed(std::size_t /*recalled*/) {}
};

class MonteCarloSession {
 public:
  /// The observer must outlive the session.
  MonteCarloSession(MonteCarloSettings settings, SessionContext context, MonteCarloObserver& observer);

  /// Runs the session. May be called only once. Returns nothing in an MPI rank other than 0, which only
  /// simulates for rank 0. Throws InputError if the perturbation is not valid, if a new run's folder is not
  /// empty, or if the folder to resume contains another run. Throws FailedError if a file cannot be written.
  /// Everything that was completed before an error stays in the folder.
  std::optional<MonteCarloOutcome> run(RankGroup& ranks);

 private:
  bool writes() const { return !settings_.place.folder.empty(); }
  const std::string& folder() const { return settings_.place.folder; }
  std::vector<std::string> inputs() const;
  RolloutPlan plan() const;
  RunHeader header() const;
  void begin();
  void draw(RolloutPool& pool);
  void keep_samples();
  void write_results(int workers);
  void write_arm();
  report::Scene scene() const;

  MonteCarloSettings settings_;
  SessionContext context_;
  MonteCarloObserver& observer_;
  Stopwatch watch_;
  std::optional<JournalledRun> run_;
  std::optional<AppendFile> rows_;  ///< samples.csv
  MonteCarloOutcome outcome_;
};

}  // namespace armtune::internal
