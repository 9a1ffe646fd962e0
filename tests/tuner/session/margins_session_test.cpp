#include "tuner/session/margins_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/common/input_file.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/robustness/margin_report.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal {
namespace margins_session_test {

namespace fs = std::filesystem;

const std::atomic<bool> kNever{false};

/// Stops the session as soon as one margin is done.
class StopAfterOneMargin : public SessionObserver {
 public:
  const std::atomic<bool>& stop() const { return stop_; }
  void progressed(const Progress& progress) override { stop_ = stop_ || progress.done > 0; }

 private:
  std::atomic<bool> stop_{false};
};

class MarginsOfTheSession : public testing::Test {
 protected:
  MarginsSettings settings(const std::string& folder) const {
    MarginsSettings settings;
    settings.folder = folder;
    settings.scenarios = {scenario_};
    settings.gains = gains_;
    settings.options.engine = Engine::kNative;
    return settings;
  }

  const InputRecord inputs_;  // so that a run keeps copies of them
  const test::ShortStudy files_;
  const Scenario scenario_ =
      load_scenario(files_.write("five_seconds.yaml", "base: moving_target\nduration: 5\n"));
  Gains gains_ = load_gains(files_ / "gains.yaml", joint_names(*scenario_.robot));
  const std::string folder_ = files_ / "margins";
};

TEST_F(MarginsOfTheSession, AreThoseThatTheSearchGivesAndItWritesWhatItNames) {
  SessionObserver silent;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const MarginsOutcome outcome = MarginsSession(settings(folder_), {kNever}, silent).run();
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
  const MarginsSettings same = settings("");
  const auto expected =
      margins_csv(same.scenarios, margins(same.scenarios, same.gains, same.options, kNever));
  EXPECT_EQ(margins_csv(same.scenarios, outcome.margins), expected);
  EXPECT_EQ(test::read_text(folder_ + "/margins.csv"), expected);
  EXPECT_EQ(outcome.ending, Ending::kPassed);
  EXPECT_EQ(outcome.verdict.checks.size(), kMarginCount);
  EXPECT_THAT(outcome.files, testing::IsSupersetOf({"margins.csv", "gains.yaml", "verdict.yaml"}));
  for (const std::string& file : outcome.files) EXPECT_TRUE(fs::exists(folder_ + "/" + file)) << file;
  EXPECT_EQ(gains_yaml(load_gains(folder_ + "/gains.yaml", joint_names(*scenario_.robot)), {}),
            gains_yaml(gains_, {}));
  const RunRecord record = find_run_record(folder_).value();
  EXPECT_EQ(record.kind, RunKind::kMargins);
  EXPECT_EQ(record.margins->margins, static_cast<long>(kMarginCount));
}

TEST_F(MarginsOfTheSession, FailTheChecksIfTheLoopDoesNotHoldAtTheNominalValue) {
  gains_.task_space_gains_p *= 100.0;
  SessionObserver silent;
  const MarginsOutcome outcome = MarginsSession(settings(""), {kNever}, silent).run();
  EXPECT_EQ(outcome.ending, Ending::kChecksFailed);
  ASSERT_EQ(outcome.margins.size(), kMarginCount);
  for (const Margin& margin : outcome.margins) EXPECT_FALSE(margin.stands) << name(margin.kind);
  EXPECT_TRUE(outcome.files.empty());
}

TEST_F(MarginsOfTheSession, InterruptedItKeepsThoseThatAreDoneAndNoVerdict) {
  StopAfterOneMargin observer;
  const MarginsOutcome outcome = MarginsSession(settings(folder_), {observer.stop()}, observer).run();
  EXPECT_EQ(outcome.ending, Ending::kInterrupted);
  ASSERT_EQ(outcome.margins.size(), 1U);
  EXPECT_TRUE(outcome.verdict.checks.empty());
  EXPECT_EQ(test::read_text(folder_ + "/margins.csv"), margins_csv({scenario_}, outcome.margins));
  EXPECT_EQ(find_run_record(folder_)->margins->margins, 1);
  EXPECT_FALSE(fs::exists(folder_ + "/verdict.yaml"));
}

}  // namespace margins_session_test
}  // namespace armtune::internal
