#pragma once
// A tuning run from its start gains to its verdict: search, fresh rollouts of what it found, analysis,
// checks, and, where it has a folder, all of its files. A run that was killed or interrupted can be resumed
// there.
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
  int workers = 1;           ///< threads
  double deadline = 0.0;     ///< of one rollout, wall clock [s]; 0: by its duration
  int record_every = 5;      ///< control periods per row of the recordings
  bool analysis = true;      ///< margins, sensitivity, and the checks that take long
  bool live = false;         ///< keep report.html fresh while the search is under way
  Yardstick yardstick = {};  ///< none: not compared with one
};

struct TuneOutcome {
  Ending ending = Ending::kInterrupted;
  bool was_finished = false;  ///< the run had ended before: nothing else is given here
  TuneResult result;          ///< without evaluations: interrupted before the start gains were simulated
  std::optional<Objective> objective;  ///< once the start gains were simulated
  /// Fresh rollouts of the start, the result and, behind them, the study's `given`; none if the session ended
  /// right after an interrupted search.
  std::vector<ComparedSet> sets;
  /// Of a study on many arms: the measure of fresh rollouts of all of them, for both.
  std::vector<ComparedSet> robust;
  std::optional<Sensitivity> sensitivity;
  SimulationVerdict verdict;
  std::vector<std::string> files;  ///< names of those in the folder
  /// Of them, the ROS parameter file that the start gains came from, with the result's; empty: a check failed
  /// or was left out, or there is no such file.
  std::string controllers;
  double seconds = 0.0;  ///< that the session took
};

/// Hears of a tuning run while it is under way.
class TuneObserver : public SessionObserver {
 public:
  /// The start gains were simulated. recalled: evaluations that a resumed run has finished before.
  virtual void began(const Study& /*study*/, std::size_t /*recalled*/) {}
  /// Of every evaluation, in order.
  virtual void evaluated(const Evaluation& /*evaluation*/) {}
  /// The result was simulated again.
  virtual void verified(const TuneOutcome& /*so_far*/) {}
  /// Margins of the start and of the result.
  virtual void found_margins(const std::vector<ComparedMargins>& /*sets*/) {}
  virtual void found_sensitivity(const Sensitivity& /*sensitivity*/) {}
  /// Nothing about the search itself changes any more; the checks follow.
  virtual void searched(const TuneOutcome& /*so_far*/) {}
  /// Scenarios were extended, all of the study's unless interrupted.
  virtual void extended(const std::vector<EnduranceResult>& /*results*/) {}
};

class TuneSession {
 public:
  /// The observer outlives the session.
  TuneSession(Study study, TuneSettings settings, SessionContext context, TuneObserver& observer);

  /// Runs it; may be called once. Returns nothing in a rank that worked for another one. Throws InputError if
  /// the folder is used or holds another run, and if the start gains give no reference; FailedError
  /// if a file cannot be written. What was finished by then is in the folder.
  std::optional<TuneOutcome> run(RankGroup& ranks);

 private:
  bool writes() const { return !settings_.place.folder.empty(); }
  const std::string& folder() const { return settings_.place.folder; }
  void begin();
  /// Extends the study's scenarios under these gains, then simulates random arms; keeps both for the checks.
  /// Returns what failed; empty: nothing.
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
  int count_ = 1;  ///< of the search's workers
  std::vector<EvaluationRow> evaluations_;
  std::vector<YardstickFiles> yardsticks_ = std::vector<YardstickFiles>(2);
  /// Checks that the search asked for already, of the gains of this file.
  struct {
    std::string gains;
    std::vector<EnduranceResult> endured;
    std::optional<SimulationVerdict> yield;
  } made_;
  std::vector<std::string> task_warnings_;  ///< notes of the verdict
  TuneOutcome outcome_;
};

}  // namespace armtune::internal
