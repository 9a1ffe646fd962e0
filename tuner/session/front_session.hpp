#pragma once
// The work of the command `armtune pareto`. It finds the Pareto front of a study, which shows how much one
// criterion gets worse when another one improves. It searches the front, and simulates every point of the
// front again. If an output folder is given, it writes all files there. A run with a folder can be resumed
// there.

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
  std::vector<std::string> criteria;  ///< names of two or three criteria; the first is minimised
  std::size_t levels = 0;             ///< limits per further criterion; 0: 12 with two criteria, 4 with three
  long max_evaluations = 0;           ///< 0: four times the number in the study
  int workers = 1;                    ///< number of threads
  double deadline = 0.0;              ///< for one rollout, wall clock [s]; 0: derived from its duration
};

struct FrontOutcome {
  Ending ending = Ending::kInterrupted;
  bool was_finished = false;  ///< true if the run had ended before; only `ending` is set then
  ParetoOptions options;
  ParetoResult result;             ///< no evaluations if interrupted while start gains were simulated
  bool verified = false;           ///< true if every point was simulated again
  std::vector<std::string> files;  ///< names of the files in the folder
  double seconds = 0.0;            ///< wall time of the session [s]
};

/// An observer of a front session.
class FrontObserver : public SessionObserver {
 public:
  /// Called when the start gains were simulated. recalled: number of evaluations that were completed before
  /// the run was resumed; 0 for a new run.
  virtual void began(const Study& /*study*/, const ParetoOptions& /*options*/, std::size_t /*recalled*/) {}
};

class FrontSession {
 public:
  /// The observer must outlive the session.
  FrontSession(Study study, FrontSettings settings, SessionContext context, FrontObserver& observer);

  /// Runs the session. May be called only once. Returns nothing in an MPI rank other than 0, which only
  /// simulates for rank 0. Throws InputError if a criterion is unknown or named twice, if a new run's folder
  /// is not empty, if the folder to resume contains another run, or if the start gains give no reference.
  /// Throws FailedError if a file cannot be written, or if a point gives different results when it is
  /// simulated again. Everything that was completed before an error stays in the folder.
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
  double last_seconds_ = 0.0;  ///< wall time of the run at the last evaluation [s]
  FrontOutcome outcome_;
};

}  // namespace armtune::internal
