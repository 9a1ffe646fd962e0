#include "tuner/session/sensitivity_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/common/input_file.hpp"
#include "tests/tuner/run/support/records.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/evaluation/evaluations_file.hpp"
#include "tuner/evaluation/simulate_points.hpp"
#include "tuner/run/file_hash.hpp"

namespace armtune::internal {
namespace sensitivity_session_test {

namespace fs = std::filesystem;

const std::atomic<bool> kNever{false};

/// A run of three evaluations. The last one gives the run's gains.
class SensitivityOfARun : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(run_);
    const auto start = simulate_points(study_, {study_.space.start_point()}, runner_, kNever);
    objective_.emplace(study_.terms, study_.constraints, study_.scenarios, start->front().results,
                       study_.source);
    EvaluationsFile file(evaluations_, study_);
    auto points = simulate_points(study_, {{0.3, 0.4}, {0.6, 0.4}, {0.5, 0.7}}, runner_, kNever);
    for (Evaluation& e : points.value()) {
      objective_->judge(e);
      file.append("search", e);
      best_ = e.gains;
    }
    files_.write("run/gains.yaml", gains_yaml(best_, {}));
    best_ = load_gains(run_ + "/gains.yaml", joint_names(*study_.scenarios.front().robot));
  }
  std::optional<SensitivityOutcome> outcome(const std::string& folder, const std::atomic<bool>& stop) const {
    SessionObserver silent;
    RankGroup alone(nullptr);
    return SensitivitySession({run_, study_, folder, 2}, {stop}, silent).run(alone);
  }

  const InputRecord inputs_;  // so that a run keeps copies of them
  const test::ShortStudy files_{test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                                "search: {algorithm: COBYLA, max_evaluations: 12, engine: native}\n"};
  const Study study_ = load_study(files_.path());
  CandidateRunner runner_{study_.scenarios, study_.stepper, 1};
  std::optional<Objective> objective_;
  const std::string run_ = files_ / "run";
  const std::string evaluations_ = run_ + "/evaluations.csv";
  const std::string folder_ = files_ / "sensitivity";
  Gains best_;
};

TEST_F(SensitivityOfARun, IsThatOfItsGainsAndEvaluations) {
  const auto kept = outcome(folder_, kNever);
  const auto bare = outcome("", kNever);
  ASSERT_TRUE(kept && bare);
  const auto rows = read_evaluations(CsvTable::read(evaluations_), study_);
  ASSERT_EQ(rows.size(), 3U);
  const std::string expected =
      sensitivity_csv(study_, *sensitivity(study_, *objective_, best_, rows, runner_, kNever));
  EXPECT_EQ(sensitivity_csv(study_, kept->sensitivity), expected);
  EXPECT_EQ(sensitivity_csv(study_, bare->sensitivity), expected);
  EXPECT_EQ(test::read_text(folder_ + "/sensitivity.csv"), expected);
  EXPECT_EQ(kept->ending, Ending::kPassed);
  EXPECT_TRUE(bare->files.empty());
}

TEST_F(SensitivityOfARun, ItsFilesAreASmallerStudyAndARecordOfWhatWasRead) {
  const auto kept = outcome(folder_, kNever);
  ASSERT_TRUE(kept);
  EXPECT_FALSE(kept->files.empty());
  for (const std::string& file : kept->files) EXPECT_TRUE(fs::exists(folder_ + "/" + file)) << file;
  const Study reduced = load_study(folder_ + "/reduced_study.yaml");
  ASSERT_EQ(reduced.space.free.size(), 1U);
  EXPECT_EQ(reduced.space.free[0].entry.name,
            study_.space.free[kept->sensitivity.parameters[0].parameter].entry.name);
  const RunRecord record = find_run_record(folder_).value();
  EXPECT_EQ(record.kind, RunKind::kSensitivity);
  for (const std::string& file : {evaluations_, run_ + "/gains.yaml"})
    EXPECT_EQ(test::input_in(record, file).hash, hash_of_file(file));
}

TEST_F(SensitivityOfARun, InterruptedItWritesNothing) {
  const std::atomic<bool> stop{true};
  const auto nothing = outcome(folder_, stop);
  ASSERT_TRUE(nothing);
  EXPECT_EQ(nothing->ending, Ending::kInterrupted);
  EXPECT_TRUE(nothing->sensitivity.parameters.empty());
  EXPECT_TRUE(fs::is_empty(folder_));
}

}  // namespace sensitivity_session_test
}  // namespace armtune::internal
