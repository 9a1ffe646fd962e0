#include "tuner/session/tune_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal {
namespace tune_session_test {

namespace fs = std::filesystem;
using test::ShortStudy;

TuneSettings settings_in(const std::string& folder, bool resume = false) {
  TuneSettings settings;
  settings.place = {folder, resume};
  settings.workers = 2;
  settings.analysis = false;
  return settings;
}

/// Stops the run once so many of its evaluations are finished.
class Interrupter : public TuneObserver {
 public:
  explicit Interrupter(long after) : after_(after) {}
  const std::atomic<bool>& stop() const { return stop_; }
  void progressed(const Progress& progress) override {
    if (progress.all > 0 && progress.done >= after_) stop_ = true;
  }
  void began(const Study& /*study*/, std::size_t recalled) override { recalled_ = recalled; }
  std::size_t recalled() const { return recalled_; }

 private:
  long after_;
  std::atomic<bool> stop_{false};
  std::size_t recalled_ = 0;
};

constexpr long kNever = 1000000;

TuneOutcome run(const Study& study, const TuneSettings& settings, Interrupter& observer) {
  RankGroup alone(nullptr);
  TuneSession session(study, settings, {observer.stop()}, observer);
  return session.run(alone).value();
}

TuneOutcome run(const Study& study, const TuneSettings& settings) {
  Interrupter whole(kNever);
  return run(study, settings, whole);
}

void expect_same_evaluation(const Evaluation& a, const Evaluation& b) {
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.objective, b.objective);
  EXPECT_EQ(a.violation, b.violation);
}

TEST(TuneSession, WithoutAFolderItGivesWhatTheSearchGives) {
  const ShortStudy files;
  const Study study = load_study(files.path());
  const std::atomic<bool> never{false};
  CandidateRunner workers(study.scenarios, study.stepper, 1);
  const TuneResult searched = tune(study, workers, never, {});
  const TuneOutcome outcome = run(study, settings_in(""));
  expect_same_evaluation(outcome.result.best, searched.best);
  EXPECT_EQ(outcome.result.evaluations, searched.evaluations);
  ASSERT_EQ(outcome.sets.size(), 2U);
  for (std::size_t s = 0; s < study.scenarios.size(); ++s) {
    EXPECT_EQ(outcome.sets[1].results[s].result.metrics[Metric::kOrientationRms],
              searched.best.results[s].metrics[Metric::kOrientationRms])
        << "fresh rollouts give the figures that the search saw";
  }
  EXPECT_TRUE(outcome.files.empty());
  EXPECT_EQ(outcome.ending, outcome.verdict.passed() ? Ending::kPassed : Ending::kChecksFailed);
}

TEST(TuneSession, ItWritesWhatItNamesAndPrintsNothing) {
  const ShortStudy files;
  const Study study = load_study(files.path());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  TuneSettings settings = settings_in(files / "run");
  settings.mcap = true;
  const TuneOutcome outcome = run(study, settings);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_THAT(outcome.files, testing::IsSupersetOf({"gains.yaml", "errors.csv", "evaluations.csv", "run.json",
                                                    "study.yaml", "verdict.yaml", "scene.json"}));
  for (const std::string& file : outcome.files) {
    EXPECT_TRUE(file.find('<') != std::string::npos || fs::is_regular_file(files / ("run/" + file))) << file;
  }
  EXPECT_TRUE(fs::is_regular_file(files / "run/rollout_short.csv"));
  EXPECT_THAT(outcome.files, testing::Contains("rollout_<scenario>.mcap"));
  EXPECT_TRUE(fs::is_regular_file(files / "run/rollout_short.mcap"));
  EXPECT_TRUE(fs::is_regular_file(files / "run/start/rollout_short.mcap"));
  EXPECT_EQ(load_gains(files / "run/gains.yaml", joint_names(*study.scenarios.front().robot))
                .slerpDurationErrorGain,
            outcome.result.best.gains.slerpDurationErrorGain);
  const RunRecord record = find_run_record(files / "run").value();
  EXPECT_EQ(record.kind, RunKind::kTune);
  ASSERT_TRUE(record.search && record.tuned);
  EXPECT_EQ(record.search->evaluations, outcome.result.evaluations);
  EXPECT_EQ(record.search->ended, outcome.result.ended);
  EXPECT_NE(record.search->ended, SearchEnd::kInterrupted);
  EXPECT_EQ(record.search->engine, study.engine);
  EXPECT_EQ(record.tuned->objective, outcome.result.best.objective);
  EXPECT_EQ(record.tuned->feasible, outcome.result.best.feasible);
  EXPECT_EQ(record.tuned->gains_hash, hash_of_file(files / "run/gains.yaml"));
}

TEST(TuneSession, InterruptedItIsResumedToTheSameBytes) {
  const ShortStudy files;
  const Study study = load_study(files.path());
  const TuneOutcome whole = run(study, settings_in(files / "whole"));
  Interrupter interrupter(4);
  const TuneOutcome part = run(study, settings_in(files / "parts"), interrupter);
  EXPECT_EQ(part.ending, Ending::kInterrupted);
  EXPECT_TRUE(part.result.interrupted);
  EXPECT_EQ(find_run_record(files / "parts")->search->ended, SearchEnd::kInterrupted);
  EXPECT_LT(part.result.evaluations, whole.result.evaluations);
  Interrupter rest(kNever);
  const TuneOutcome resumed = run(study, settings_in(files / "parts", true), rest);
  EXPECT_GE(rest.recalled(), static_cast<std::size_t>(part.result.evaluations));
  EXPECT_EQ(resumed.ending, whole.ending);
  for (const char* file : {"gains.yaml", "errors.csv", "study.yaml", "rollout_short.csv", "verdict.yaml"}) {
    EXPECT_EQ(test::read_text(files / (std::string("parts/") + file)),
              test::read_text(files / (std::string("whole/") + file)))
        << file;
  }
  const TuneOutcome again = run(study, settings_in(files / "parts", true));
  EXPECT_TRUE(again.was_finished);
  EXPECT_EQ(again.ending, whole.ending);
}

TEST(TuneSession, InterruptedAtOnceItLeavesNoFolder) {
  const ShortStudy files;
  Interrupter at_once(kNever);
  const std::atomic<bool> stop{true};
  RankGroup alone(nullptr);
  TuneSession session(load_study(files.path()), settings_in(files / "run"), {stop}, at_once);
  const auto outcome = session.run(alone);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->ending, Ending::kInterrupted);
  EXPECT_EQ(outcome->result.evaluations, 0);
  EXPECT_FALSE(fs::exists(files / "run"));
}

}  // namespace tune_session_test
}  // namespace armtune::internal
