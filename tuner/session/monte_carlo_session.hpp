#pragma once
// A run that simulates a gain set on many arms that differ at random from the model: samples, their spread,
// the verdict on the yield, and, where it has a folder, all of its files. It can be resumed there.

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
  std::string gains_path;     ///< of the file that the gains are from; empty: of none
  double deadline = 0.0;      ///< of one rollout, wall clock [s]; 0: by its duration
  bool writes_arm = false;    ///< one sample's arm is written as a URDF and a robot YAML
  MonteCarloOptions options;  ///< but for its functions, which are the session's own
};

struct MonteCarloOutcome {
  Ending ending = Ending::kInterrupted;
  bool was_finished = false;              ///< the run had ended before: nothing else is given here
  std::vector<MonteCarloSample> samples;  ///< in the order of their numbers, up to the first that is missing
  SimulationVerdict verdict;              ///< without checks if interrupted
  bool recorded = false;                  ///< the scenarios' own arm was simulated as well, in nominal/
  std::vector<std::string> files;         ///< names of those in the folder
};

/// Hears of such a run while it is under way.
class MonteCarloObserver : public SessionObserver {
 public:
  /// The run is resumed, with so many samples finished before.
  virtual void resumed(std::size_t /*recalled*/) {}
};

class MonteCarloSession {
 public:
  /// The observer outlives the session.
  MonteCarloSession(MonteCarloSettings settings, SessionContext context, MonteCarloObserver& observer);

  /// Runs it; may be called once. Returns nothing in a rank that worked for another one. Throws InputError if
  /// the perturbation is not valid or the folder is used or holds another run; FailedError if a file
  /// cannot be written. What was finished by then is in the folder.
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
