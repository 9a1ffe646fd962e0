#pragma once
// A run that finds the front of a study: what less of one criterion costs in another. Search, fresh rollouts
// of every point, and, where it has a folder, all of its files. It can be resumed there.

#include <optional>
#include <string>
#include <vector>

#include "tuner/evaluation/evaluations_file.hpp"
#include "tuner/report/scene.hpp"
#include "tuner/session/journalled_run.hpp"
#include "tuner/trade_off/pareto.hpp"
#include "tuner/workers/rank_group.hpp"

namespace armtune::internal {

struct FrontSettings {
  RunPlace place = {};
  std::vector<std::string> criteria;  ///< names of two or three; the first is searched
  std::size_t levels = 0;             ///< of each other criterion; 0: 12, with three criteria 4
  long max_evaluations = 0;           ///< 0: four times the study's
  int workers = 1;                    ///< threads
  double deadline = 0.0;              ///< of one rollout, wall clock [s]; 0: by its duration
};

struct FrontOutcome {
  Ending ending = Ending::kInterrupted;
  bool was_finished = false;  ///< the run had ended before: nothing else is given here
  ParetoOptions options;
  ParetoResult result;             ///< without evaluations: interrupted before the start gains were simulated
  bool verified = false;           ///< every point was simulated again
  std::vector<std::string> files;  ///< names of those in the folder
  double seconds = 0.0;            ///< that the session took
};

/// Hears of such a run while it is under way.
class FrontObserver : public SessionObserver {
 public:
  /// The start gains were simulated. recalled: evaluations that a resumed run has finished before.
  virtual void began(const Study& /*study*/, const ParetoOptions& /*options*/, std::size_t /*recalled*/) {}
};

class FrontSession {
 public:
  /// The observer outlives the session.
  FrontSession(Study study, FrontSettings settings, SessionContext context, FrontObserver& observer);

  /// Runs it; may be called once. Returns nothing in a rank that worked for another one. Throws InputError if
  /// a criterion is unknown or named twice, if the folder is used or holds another run, and if the start
  /// gains give no reference; FailedError if a file cannot be written or a point simulated again
  /// gives other figures. What was finished by then is in the folder.
  std::optional<FrontOutcome> run(RankGroup& ranks);

 private:
  bool writes() const { return !settings_.place.folder.empty(); }
  const std::string& folder() const { return settings_.place.folder; }
  ParetoOptions options() const;
  RunHeader header() const;
  void search(RankGroup& ranks, CandidateRunner& workers);
  ParetoCallbacks callbacks();
  void write_front() const;
  void write_reports(int workers);
  report::Scene scene(bool recorded) const;

  Study study_;
  FrontSettings settings_;
  SessionContext context_;
  FrontObserver& observer_;
  Stopwatch watch_;
  std::optional<JournalledRun> run_;
  std::optional<Objective> objective_;
  std::optional<EvaluationsFile> evaluations_;
  double last_seconds_ = 0.0;  ///< of the last evaluation
  FrontOutcome outcome_;
};

}  // namespace armtune::internal
