// Front, Monte Carlo, simulate and compare in process.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "core/common/input_file.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/run/run_record.hpp"
#include "tuner/session/compare_session.hpp"
#include "tuner/session/front_session.hpp"
#include "tuner/session/monte_carlo_session.hpp"

namespace armtune::internal {
namespace other_sessions_test {

namespace fs = std::filesystem;
using test::ShortStudy;

const std::atomic<bool> kNever{false};

void expect_files(const std::string& folder, const std::vector<std::string>& files) {
  EXPECT_FALSE(files.empty());
  for (const std::string& file : files) {
    EXPECT_TRUE(file.find('<') != std::string::npos || fs::exists(fs::path(folder) / file)) << file;
  }
}

FrontSettings front_settings(const std::string& folder) {
  FrontSettings settings;
  settings.place.folder = folder;
  settings.criteria = {"objective", "joint_velocity/max_ratio"};
  settings.levels = 2;
  settings.max_evaluations = 20;
  settings.workers = 2;
  return settings;
}

TEST(FrontSession, WithAndWithoutAFolderItGivesTheFrontThatTheSearchGives) {
  const InputRecord inputs;  // so that a run keeps copies of them
  const ShortStudy files;
  const Study study = load_study(files.path());
  RankGroup alone(nullptr);
  FrontObserver silent;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const auto bare = FrontSession(study, front_settings(""), {kNever}, silent).run(alone);
  const auto kept = FrontSession(study, front_settings(files / "run"), {kNever}, silent).run(alone);
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
  ASSERT_TRUE(bare && kept);
  CandidateRunner workers(study.scenarios, study.stepper, 1);
  const ParetoResult found = pareto(study, bare->options, workers, kNever, {});
  ASSERT_FALSE(found.front.empty());
  for (const auto& outcome : {*bare, *kept}) {
    EXPECT_TRUE(outcome.verified);
    EXPECT_EQ(outcome.ending, Ending::kPassed);
    ASSERT_EQ(outcome.result.front.size(), found.front.size());
    for (std::size_t i = 0; i < found.front.size(); ++i)
      EXPECT_EQ(outcome.result.front[i].costs, found.front[i].costs) << i;
  }
  EXPECT_TRUE(bare->files.empty());
  expect_files(files / "run", kept->files);
}

MonteCarloSettings monte_carlo_settings(const Study& study, const std::string& folder) {
  MonteCarloSettings settings;
  settings.place.folder = folder;
  settings.scenarios = study.scenarios;
  settings.gains = study.space.start;
  settings.gains_path = study.gains;
  settings.options.samples = 6;
  settings.options.workers = 2;
  return settings;
}

/// Stops once so many samples' rollouts are done.
class SampleInterrupter : public MonteCarloObserver {
 public:
  explicit SampleInterrupter(long rollouts) : rollouts_(rollouts) {}
  const std::atomic<bool>& stop() const { return stop_; }
  void progressed(const Progress& progress) override { stop_ = stop_ || progress.done >= rollouts_; }
  void resumed(std::size_t recalled) override { recalled_ = recalled; }
  std::size_t recalled() const { return recalled_; }

 private:
  long rollouts_;
  std::atomic<bool> stop_{false};
  std::size_t recalled_ = 0;
};

TEST(MonteCarloSession, InterruptedItIsResumedToTheSameSamples) {
  const InputRecord inputs;  // so that a run keeps copies of them
  const ShortStudy files;
  const Study study = load_study(files.path());
  RankGroup alone(nullptr);
  MonteCarloObserver silent;
  const auto bare = MonteCarloSession(monte_carlo_settings(study, ""), {kNever}, silent).run(alone);
  ASSERT_TRUE(bare);
  EXPECT_EQ(bare->samples.size(), 6U);
  EXPECT_TRUE(bare->files.empty());

  SampleInterrupter interrupter(5);
  auto settings = monte_carlo_settings(study, files / "run");
  const auto part = MonteCarloSession(settings, {interrupter.stop()}, interrupter).run(alone);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->ending, Ending::kInterrupted);
  EXPECT_LT(part->samples.size(), 6U);
  SampleInterrupter rest(1000);
  settings.place.resume = true;
  const auto whole = MonteCarloSession(settings, {rest.stop()}, rest).run(alone);
  ASSERT_TRUE(whole);
  EXPECT_GE(rest.recalled(), part->samples.size());
  EXPECT_GE(rest.recalled(), 1U);
  const std::string expected = samples_csv(study.scenarios, settings.options, bare->samples);
  EXPECT_EQ(samples_csv(study.scenarios, settings.options, whole->samples), expected);
  EXPECT_EQ(test::read_text(files / "run/samples.csv"), expected);
  EXPECT_EQ(whole->ending, bare->ending);
  expect_files(files / "run", whole->files);
}

GainsToSimulate as_named(const std::string& name, const Study& study) {
  return {name, study.gains, [&study](const Scenario&) { return study.space.start; }};
}

TEST(SimulateSession, WithAndWithoutAFolderTheRolloutsAreTheSame) {
  const InputRecord inputs;  // so that a run keeps copies of them
  const ShortStudy files;
  const Study study = load_study(files.path());
  SessionObserver silent;
  RolloutSettings settings;
  settings.scenarios = study.scenarios;
  const auto bare = SimulateSession(settings, as_named("start", study), {kNever}, silent).run();
  settings.folder = files / "run";
  settings.workers = 2;
  const auto kept = SimulateSession(settings, as_named("start", study), {kNever}, silent).run();
  EXPECT_EQ(errors_csv(bare.results), errors_csv(kept.results));
  EXPECT_EQ(errors_csv(bare.results), test::read_text(files / "run/errors.csv"));
  EXPECT_EQ(bare.ending, kept.ending);
  EXPECT_TRUE(bare.files.empty());
  expect_files(settings.folder, kept.files);
}

TEST(SimulateSession, AndCompareSessionWriteAnMcapFileBesideEachRecordingIfAsked) {
  const ShortStudy files;
  const Study study = load_study(files.path());
  SessionObserver silent;
  RolloutSettings settings;
  settings.scenarios = {study.scenarios.front()};
  const std::string name = "/rollout_" + settings.scenarios.front().name + ".mcap";
  std::vector<std::string> named;
  for (const bool mcap : {false, true}) {
    settings.mcap = mcap;
    settings.folder = files / (mcap ? "with" : "without");
    named = SimulateSession(settings, as_named("start", study), {kNever}, silent).run().files;
    EXPECT_EQ(fs::exists(settings.folder + name), mcap);
    EXPECT_EQ(std::count(named.begin(), named.end(), "rollout_<scenario>.mcap"), mcap ? 1 : 0);
  }
  settings.folder = files / "sets";
  CompareSession(settings, {as_named("a", study)}, {kNever}, silent).run();
  EXPECT_TRUE(test::read_text(files / "with" + name) == test::read_text(files / "sets/rollouts_a" + name));
}

TEST(SimulateSession, SaysWhatSimbodyDidNotSimulate) {
  const ShortStudy files;
  const Study study = load_study(files.path());
  SessionObserver silent;
  RolloutSettings settings;
  settings.scenarios = {study.scenarios.front()};
  const auto says = testing::Contains(testing::HasSubstr("Simbody did not simulate"));
  const auto simbody = SimulateSession(settings, as_named("start", study), {kNever}, silent).run();
  EXPECT_THAT(simbody.verdict.assumes, testing::Not(says));
  settings.engine = Engine::kNative;
  EXPECT_THAT(SimulateSession(settings, as_named("start", study), {kNever}, silent).run().verdict.assumes,
              says);
  EXPECT_THAT(CompareSession(settings, {as_named("one", study)}, {kNever}, silent).run().verdict.assumes,
              says);
}

TEST(CompareSession, IsWholeOrNothing) {
  const InputRecord inputs;  // so that a run keeps copies of them
  const ShortStudy files;
  const Study study = load_study(files.path());
  SessionObserver silent;
  RolloutSettings settings;
  settings.scenarios = study.scenarios;
  settings.folder = files / "whole";
  const std::vector<GainsToSimulate> sets = {as_named("one", study), as_named("other", study)};
  const auto whole = CompareSession(settings, sets, {kNever}, silent).run();
  ASSERT_EQ(whole.sets.size(), 2U);
  EXPECT_EQ(errors_csv(whole.sets[0].results), errors_csv(whole.sets[1].results));
  expect_files(settings.folder, whole.files);
  const RunRecord record = find_run_record(settings.folder).value();
  EXPECT_EQ(record.compare->sets, (std::vector<std::string>{"one", "other"}));
  const auto shown = report::usual_sets(RunKind::kCompare, settings.folder);
  ASSERT_EQ(shown.size(), 2U);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    EXPECT_EQ(shown[i].name, record.compare->sets[i]);
    EXPECT_TRUE(fs::exists(fs::path(settings.folder) / shown[i].errors)) << shown[i].errors;
  }

  const std::atomic<bool> stop{true};
  settings.folder = files / "nothing";
  const auto nothing = CompareSession(settings, sets, {stop}, silent).run();
  EXPECT_EQ(nothing.ending, Ending::kInterrupted);
  EXPECT_TRUE(nothing.sets.empty());
  EXPECT_TRUE(fs::is_empty(settings.folder));
}

}  // namespace other_sessions_test
}  // namespace armtune::internal
