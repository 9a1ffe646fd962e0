#pragma once
// The work of the command `armtune tune`, from the start gains to the verdict. It searches for better gains.
// Then it simulates, analyses and checks the result. If the session has an output folder, it writes all files
// there, and a run that was killed or interrupted can be resumed.
//
//   TuneObserver silent;
//   std::atomic<bool> stop{false};
//   RankGroup alone(nullptr);
//   TuneSession session(load_study("ur10_gaze"), {}, {stop}, silent);
//   const Gains tuned = session.run(alone)->result.best.gains;

#include <optional>
#include <string>
#include <vector>

#include "tuner/endurance/endurance.hpp"
#include "tuner/evaluation/evaluations_reader.hpp"
#include "tuner/robustness/margin_report.hpp"
#include "tuner/rollouts/comparison.hpp"
#include "tuner/search/tune.hpp"
#include "tuner/sensitivity/sensitivity.hpp"
#include "tuner/session/journalled_run.hpp"
#include "tuner/session/yardstick_files.hpp"
#include "tuner/verdict/search_checks.hpp"
#include "tuner/verdict/verdict.hpp"
#include "tuner/workers/rank_group.hpp"

namespace armtune::internal {

struct TuneSettings {
  RunPlace place = {};
  int workers = 1;           ///< number of threads
  double deadline = 0.0;     ///< for one rollout, wall clock [s]; 0: derived from its duration
  int record_every = 5;      ///< control periods per row of the recordings
  bool analysis = true;      ///< true: compute margins and sensitivities, and make the long checks
  bool live = false;         ///< true: rewrite report.html every few seconds during the search
  bool mcap = false;         ///< true: also write the recordings as MCAP files (motion_bag.hpp)
  Yardstick yardstick = {};  ///< comparison with the best possible motions; empty: no comparison
};

struct TuneOutcome {
  Ending ending = Ending::kInterrupted;
  bool was_finished = false;           ///< true if the run had ended before; only `ending` is set then
  TuneResult result;                   ///< no evaluations if interrupted while start gains were simulated
  std::optional<Objective> objective;  ///< set once the start gains were simulated
  /// Results of simulate_again(): for the start gains, the resulting gains and, if the study has them, the
  /// gains Study::given. Empty if the session ended right after an interrupted search.
  std::vector<ComparedSet> sets;
  /// Results of simulate_arms_again(), for the start gains and the resulting gains. Empty unless the study
  /// tunes on several arms.
  std::vector<ComparedSet> robust;
  std::optional<Sensitivity> sensitivity;
  SimulationVerdict verdict;
  std::vector<std::string> files;  ///< names of the files in the folder
  /// Name of the ROS parameter file with the resulting gains (write_controllers). Empty if a check failed or
  /// was left out, or if the start gains were not read from such a file.
  std::string controllers;
  double seconds = 0.0;  ///< wall time of the session [s]
};

/// An observer of a tuning session.
class TuneObserver : public SessionObserver {
 public:
  /// Called when the start gains were simulated. recalled: number of evaluations that were completed before
  /// the run was resumed; 0 for a new run.
  virtual void began(const Study& /*study*/, std::size_t /*recalled*/) {}
  /// Called for every evaluation, in order.
  virtual void evaluated(const Evaluation& /*evaluation*/) {}
  /// Called when the resulting gains were simulated again.
  virtual void verified(const TuneOutcome& /*so_far*/) {}
  /// Called with the stability margins of the start gains and of the resulting gains.
  virtual void found_margins(const std::vector<ComparedMargins>& /*sets*/) {}
  virtual void found_sensitivity(const Sensitivity& /*sensitivity*/) {}
  /// Called when search and analysis are finished, before the checks.
  virtual void searched(const TuneOutcome& /*so_far*/) {}
  /// Called with the results of the extended scenarios. If the run was interrupted, some may be missing.
  virtual void extended(const std::vector<EnduranceResult>& /*results*/) {}
};

class TuneSession {
 public:
  /// The observer must outlive the session.
  TuneSession(Study study, TuneSettings settings, SessionContext context, TuneObserver& observer);

  /// Runs the session. May be called only once. Returns nothing in an MPI rank other than 0, which only
  /// simulates for rank 0. Throws InputError if a new run's folder is not empty, if the folder to resume
  /// contains another run, or if the start gains give no reference. Throws FailedError if a file cannot be
  /// written. Everything that was completed before an error stays in the folder.
  std::optional<TuneOutcome> run(RankGroup& ranks);

 private:
  bool writes() const { return !settings_.place.folder.empty(); }
  const std::string& folder() const { return settings_.place.folder; }
  void begin();
  /// Simulates the study's extended scenarios with these gains, and then random arms. Keeps both results for
  /// the checks. Returns the first check that failed as a text; empty if none failed.
  std::string fault_of(const Gains& gains);
  void search(CandidateRunner& workers);
  TuneResult search_with_files(CandidateRunner& workers);
  void verify(RankGroup& ranks);
  void write_reports();
  bool analyse(CandidateRunner& workers);
  void check(bool analysed);
  void extend_scenarios(const Gains& gains);
  void check_yield();
  void check_endurance();
  DeepCheckOptions deep_checks() const;
  void write_controllers_if_any();
  void conclude(bool analysed);

  Study study_;
  TuneSettings settings_;
  SessionContext context_;
  TuneObserver& observer_;
  Stopwatch watch_;
  std::optional<JournalledRun> run_;
  int count_ = 1;  ///< number of the search's workers
  std::vector<EvaluationRow> evaluations_;
  std::vector<YardstickFiles> yardsticks_ = std::vector<YardstickFiles>(2);
  /// Results of the checks that were made during the search. gains: text of a gains file with the gains to
  /// which they belong.
  struct {
    std::string gains;
    std::vector<EnduranceResult> endured;
    std::optional<SimulationVerdict> yield;
  } made_;
  std::vector<std::string> task_warnings_;  ///< for the verdict's notes
  TuneOutcome outcome_;
};

}  // namespace armtune::internal
