#pragma once
// The work of the command `armtune tune`, from the start gains to the verdict. It searches for better gains,
// simulates the result again, analyses and checks it. If it has an output folder, it writes all files. A run
// with a folder that was killed or interrupted can be resumed there.
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
  double deadline = 0.0;     ///< for one rollout, wall clock [s]; 0: derived from its duration
  int record_every = 5;      ///< control periods per row of the recordings
  bool analysis = true;      ///< margins, sensitivity, and the checks that take long
  bool live = false;         ///< true: rewrite report.html while the search is under way
  Yardstick yardstick = {};  ///< empty: no comparison with a yardstick
};

struct TuneOutcome {
  Ending ending = Ending::kInterrupted;
  bool was_finished = false;           ///< true if the run had ended before; only `ending` is set then
  TuneResult result;                   ///< no evaluations: interrupted before the start gains were simulated
  std::optional<Objective> objective;  ///< set once the start gains were simulated
  /// Fresh rollouts of the start and the result, followed by the study's `given` if it has any. Empty if the
  /// session ended right after an interrupted search.
  std::vector<ComparedSet> sets;
  /// Risk measure of fresh rollouts of all arms, for the start and the result. Only for a study on many arms.
  std::vector<ComparedSet> robust;
  std::optional<Sensitivity> sensitivity;
  SimulationVerdict verdict;
  std::vector<std::string> files;  ///< names of the files in the folder
  /// Name of the ROS parameter file among them: the file of the start gains, with the result's gains. Empty
  /// if a check failed or was left out, or if there is no such file.
  std::string controllers;
  double seconds = 0.0;  ///< wall time of the session [s]
};

/// An observer of a tuning session.
class TuneObserver : public SessionObserver {
 public:
  /// Called when the start gains were simulated. recalled: number of evaluations that a resumed run had
  /// completed before.
  virtual void began(const Study& /*study*/, std::size_t /*recalled*/) {}
  /// Called for every evaluation, in order.
  virtual void evaluated(const Evaluation& /*evaluation*/) {}
  /// Called when the result was simulated again.
  virtual void verified(const TuneOutcome& /*so_far*/) {}
  /// Called with the margins of the start and of the result.
  virtual void found_margins(const std::vector<ComparedMargins>& /*sets*/) {}
  virtual void found_sensitivity(const Sensitivity& /*sensitivity*/) {}
  /// Called when nothing about the search itself changes any more. The checks follow.
  virtual void searched(const TuneOutcome& /*so_far*/) {}
  /// Called when scenarios were extended: all scenarios of the study unless interrupted.
  virtual void extended(const std::vector<EnduranceResult>& /*results*/) {}
};

class TuneSession {
 public:
  /// The observer must outlive the session.
  TuneSession(Study study, TuneSettings settings, SessionContext context, TuneObserver& observer);

  /// Runs the session; may be called once. Returns nothing in a rank that worked for another rank. Throws
  /// InputError if the folder is used or holds another run, or if the start gains give no reference. Throws
  /// FailedError if a file cannot be written. Everything completed before an error stays in the folder.
  std::optional<TuneOutcome> run(RankGroup& ranks);

 private:
  bool writes() const { return !settings_.place.folder.empty(); }
  const std::string& folder() const { return settings_.place.folder; }
  void begin();
  /// Extends the study's scenarios under these gains, then simulates random arms. Keeps both results for the
  /// checks. Returns which check failed; empty: none.
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
  /// Results of the checks that the search has made already. gains: text of the gains file they apply to.
  struct {
    std::string gains;
    std::vector<EnduranceResult> endured;
    std::optional<SimulationVerdict> yield;
  } made_;
  std::vector<std::string> task_warnings_;  ///< for the verdict's notes
  TuneOutcome outcome_;
};

}  // namespace armtune::internal
