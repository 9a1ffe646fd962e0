#include "tuner/planning/session/yardstick_session.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/planning/session/add_yardstick.hpp"
#include "tuner/planning/yardstick/yardstick_file.hpp"
#include "tuner/session/simulate_session.hpp"

namespace armtune::internal {
namespace yardstick_session_test {

namespace fs = std::filesystem;

const std::atomic<bool> kNever{false};

/// Keeps what it is told, and stops the session after so many results.
class Listener : public YardstickObserver {
 public:
  explicit Listener(std::size_t results = 1000) : results_(results), stop_(results == 0) {}
  void warned(const std::string& sentence) override { warnings.push_back(sentence); }
  void noted(const std::string& scenario, const std::string& /*note*/) override {
    noted_.push_back(scenario);
  }
  void measured(const Measure& measure, std::size_t scenario) override {
    EXPECT_EQ(scenario, 0U);
    measures.push_back(measure);
    stop_ = measures.size() >= results_;
  }
  const std::atomic<bool>& stop() const { return stop_; }
  const std::vector<std::string>& noted_scenarios() const { return noted_; }

  std::vector<Measure> measures;
  std::vector<std::string> warnings;

 private:
  std::vector<std::string> noted_;
  std::size_t results_;
  std::atomic<bool> stop_;
};

/// A run of a scenario of 6 s whose targets switch at 4 s: a return and a switch.
class YardstickOfARun : public testing::Test {
 protected:
  void SetUp() override {
    RolloutSettings settings;
    settings.folder = run_;
    settings.scenarios = {scenario_};
    settings.engine = Engine::kNative;
    SessionObserver silent;
    SimulateSession(settings, {"gains", files_ / "gains.yaml", [this](const Scenario&) { return gains_; }},
                    {kNever}, silent)
        .run();
  }
  YardstickSettings settings(const std::string& out) const {
    YardstickSettings settings;
    settings.folder = run_;
    settings.out = out;
    settings.options.knots = 30;
    return settings;
  }

  const test::ShortStudy files_;
  const std::string run_ = files_ / "run";
  const Scenario scenario_ =
      load_scenario(files_.write("quick_switch.yaml", "base: target_switch\nduration: 6\nswitch_every: 4\n"));
  const Gains gains_ = load_gains(files_ / "gains.yaml", joint_names(*scenario_.robot));
};

TEST_F(YardstickOfARun, HasTheResultOfThePlannerForEveryEvent) {
  Listener listener;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const YardstickOutcome outcome = YardstickSession(settings(files_ / "own.csv"), {kNever}, listener).run();
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(outcome.ending, Ending::kPassed);

  YardstickOptions options = settings("").options;
  options.gaze_threshold = gains_.slerpAngularErrorThreshold;
  const CsvTable rollout = CsvTable::read(run_ + "/rollout_quick_switch.csv");
  std::vector<Measure> expected;
  for (const Event& event : events_of(rollout, scenario_, options.gaze_threshold))
    expected.push_back(measure(event, scenario_, options, [](const auto&) { return true; }));
  ASSERT_EQ(expected.size(), 2U);
  EXPECT_EQ(yardstick_csv(outcome.measures), yardstick_csv(expected));
  EXPECT_EQ(yardstick_csv(listener.measures), yardstick_csv(expected));
  EXPECT_EQ(test::read_text(files_ / "own.csv"), yardstick_csv(expected));
  EXPECT_EQ(outcome.files, (std::vector<std::string>{files_ / "own.csv", files_ / "own.json"}));
  EXPECT_FALSE(fs::exists(run_ + "/yardstick.csv"));
}

TEST_F(YardstickOfARun, InTheRunsFolderAllNamedFilesAreThere) {
  Listener listener;
  const YardstickOutcome outcome = YardstickSession(settings(""), {kNever}, listener).run();
  EXPECT_GE(outcome.files.size(), 3U) << "the comparison, its provenance and the columns";
  for (const std::string& file : outcome.files) {
    EXPECT_TRUE(file.starts_with(run_ + "/")) << file;
    EXPECT_TRUE(fs::is_regular_file(file)) << file;
  }
}

TEST_F(YardstickOfARun, InterruptedItWritesTheFinishedEventsIfThereAreAny) {
  Listener at_once(0);
  const YardstickOutcome none = YardstickSession(settings(""), {at_once.stop()}, at_once).run();
  EXPECT_EQ(none.ending, Ending::kInterrupted);
  EXPECT_TRUE(none.measures.empty());
  EXPECT_TRUE(none.files.empty());
  EXPECT_FALSE(fs::exists(run_ + "/yardstick.csv"));

  Listener after_one(1);
  const YardstickOutcome one = YardstickSession(settings(""), {after_one.stop()}, after_one).run();
  EXPECT_EQ(one.ending, Ending::kInterrupted);
  ASSERT_EQ(one.measures.size(), 1U);
  EXPECT_EQ(test::read_text(run_ + "/yardstick.csv"), yardstick_csv(one.measures));
}

TEST(AddYardstick, WithoutRecordingsItOnlyWarns) {
  const test::TemporaryFolder folder;
  Listener listener;
  const YardstickFiles files = add_yardstick(
      folder.path(), {load_scenario("target_switch")}, [](const Scenario&) { return Gains(); }, kNever,
      listener);
  EXPECT_EQ(listener.warnings.size(), 1U);
  EXPECT_TRUE(files.written.empty() && files.errors.empty() && files.columns.empty());
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(MeasureRollouts, LeavesOutWhatPlansDoNotModel) {
  const test::TemporaryFolder folder;
  const Scenario step = load_scenario("step_position");
  ASSERT_TRUE(step.stimulus);
  Listener listener;
  const RolloutMeasures found = measure_rollouts(
      folder.path(), {step}, [](const Scenario&) { return Gains(); }, {}, kNever, listener);
  EXPECT_TRUE(found.measures.empty());
  EXPECT_EQ(listener.noted_scenarios(), (std::vector<std::string>{"step_position"}));
}

}  // namespace yardstick_session_test
}  // namespace armtune::internal
