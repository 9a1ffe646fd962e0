#include "sim/rollout/error_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/sim/support/csv.hpp"
#include "tests/sim/support/read_back.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace error_report_test {

std::vector<ScenarioResult> two_results() {
  std::mt19937_64 generator(8);
  std::uniform_real_distribution<double> exponent(-15.0, 15.0);
  std::vector<ScenarioResult> results(2);
  results[0].scenario = "first";
  for (double& v : results[0].result.metrics.value) v = std::pow(10.0, exponent(generator));
  results[0].result.metrics.max_ratio_joint = "elbow_joint";
  results[1].scenario = "second";
  results[1].result.status = RolloutStatus::kDiverged;
  results[1].result.reason = "diverged at 4.2 s, in \"followTrajectory\"";
  return results;
}

TEST(ErrorsCsv, HasTheColumnsInTheirOrder) {
  const test::Csv csv(errors_csv(two_results()));
  EXPECT_THAT(
      csv.header,
      testing::ElementsAre(
          "scenario", "status", "error/position/x/max", "error/position/y/max", "error/position/z/max",
          "error/position/rms", "error/position/max", "error/orientation/x/max", "error/orientation/y/max",
          "error/orientation/z/max", "error/orientation/rms", "error/orientation/max",
          "error/linear_velocity/rms", "error/linear_velocity/max", "error/angular_velocity/rms",
          "error/angular_velocity/max", "samples", "gaze/rms", "gaze/max", "gaze/rate_error/rms",
          "gaze/rate_error/max", "gaze/time_outside_threshold", "reacquisition/time",
          "joint_velocity/max_ratio", "joint_velocity/max_ratio_joint", "joint_velocity/max_ratio_time",
          "joint_position/min_margin", "joint_effort/rms", "joint_effort/max_ratio",
          "joint_effort/saturated_periods", "joint_acceleration/max", "joint_acceleration/max_ratio",
          "joint_jerk/max", "joint_error/rms", "joint_error/max", "tool_error/rms", "tool_error/max",
          "goal/settling_time", "goal/overshoot", "effort_rate/rms", "obstacle/min_clearance",
          "clearance/self", "clearance/cell", "clearance/floor", "compensation_error/rms",
          "response/rise_time", "response/overshoot", "response/settling_time", "response/steady_state_error",
          "response/bandwidth", "reason"));
}

TEST(ErrorsCsv, NumbersReadBackToTheBitAndNoValueIsAnEmptyCell) {
  const auto results = two_results();
  const test::Csv csv(errors_csv(results));
  ASSERT_EQ(csv.rows.size(), 2U);
  EXPECT_EQ(csv.at(0, "status"), "completed");
  EXPECT_EQ(csv.at(1, "status"), "diverged");
  EXPECT_EQ(csv.at(0, "reason"), "");
  EXPECT_EQ(csv.at(1, "reason"), results[1].result.reason);
  EXPECT_EQ(csv.at(0, "joint_velocity/max_ratio_joint"), "elbow_joint");
  for (std::size_t r = 0; r < 2; ++r) {
    EXPECT_EQ(csv.rows[r].size(), csv.header.size());
    for (std::size_t i = 0; i < kMetricCount; ++i) {
      const std::string cell = csv.at(r, metric_fields()[i].name);
      const double value = results[r].result.metrics.value[i];
      if (std::isnan(value)) {
        EXPECT_EQ(cell, "");
      } else {
        EXPECT_EQ(std::stod(cell), value) << metric_fields()[i].name;
      }
    }
  }
}

TEST(ErrorsCsv, FurtherColumnsStandBehindTheMetricsAndChangeNothingElse) {
  const auto results = two_results();
  const std::vector<FurtherColumn> further = {{{"reacquisition/limit", "s", "the least", {}}, {0.1, NAN}}};
  const test::Csv plain(errors_csv(results));
  const test::Csv csv(errors_csv(results, further));
  auto header = plain.header;
  header.insert(header.end() - 1, "reacquisition/limit");
  EXPECT_EQ(csv.header, header);
  EXPECT_EQ(csv.at(0, "reacquisition/limit"), "0.1");
  EXPECT_EQ(csv.at(1, "reacquisition/limit"), "");
  for (std::size_t r = 0; r < 2; ++r) {
    for (const std::string& name : plain.header) EXPECT_EQ(csv.at(r, name), plain.at(r, name)) << name;
  }
  ASSERT_EQ(error_columns(further).size(), header.size());
  for (std::size_t i = 0; i < header.size(); ++i) EXPECT_EQ(error_columns(further)[i].name, header[i]);
}

TEST(ErrorsCsv, ReadsBackToTheBitAndIsEmptyForWhatIsNotFinite) {
  std::vector<ScenarioResult> results(4);
  FurtherColumn further{{"reacquisition/limit", "s", "the least", {}}, {}};
  for (std::size_t r = 0; r < results.size(); ++r) {
    RolloutResult& result = results[r].result;
    results[r].scenario = r == 0 ? test::kAwkwardText : test::kFormula;
    result.status = r == 0 ? RolloutStatus::kCompleted : RolloutStatus::kDiverged;
    result.reason = r == 0 ? "" : r == 1 ? test::kAwkwardText : test::kFormula;
    result.metrics.max_ratio_joint = r == 0 ? test::kAwkwardText : "";
    for (std::size_t m = 0; m < kMetricCount; ++m)
      result.metrics.value[m] = (m + r) % 3 == 0 ? test::no_figures()[(m / 3) % 4] : test::awkward(m + r);
    further.values.push_back(r == 1 ? INFINITY : test::awkward(r));
  }
  test::ReadBack read(errors_csv(results, {further}));
  for (std::size_t r = 0; r < results.size(); ++r) {
    const RolloutResult& result = results[r].result;
    read.text(r, "scenario", results[r].scenario);
    read.text(r, "status", name(result.status));
    read.text(r, "joint_velocity/max_ratio_joint", result.metrics.max_ratio_joint);
    for (const Metric m : all_metrics()) read.number(r, name(m), result.metrics[m]);
    read.number(r, "reacquisition/limit", further.values[r]);
    read.text(r, "reason", result.reason);
  }
  read.expect_all_seen(results.size());
}

TEST(ColumnsCsv, ReadsBackWhateverIsInATextAndIsEmptyWithoutUnit) {
  const std::vector<FileColumns> files = {
      {"errors.csv", error_columns()},
      {test::kAwkwardText,
       {{"a, b/\"c\"", "N m, N", "says \"what, when\"", {}}, {test::kFormula, "", "", {}}}}};
  test::ReadBack read(columns_csv(files));
  std::size_t row = 0;
  for (const FileColumns& file : files) {
    for (const Column& column : file.columns) {
      read.text(row, "file", file.file);
      read.text(row, "name", column.name);
      read.text(row, "unit", column.unit);
      read.text(row++, "meaning", column.meaning);
    }
  }
  read.expect_all_seen(row);
}

TEST(ColumnsCsv, ExplainsEveryColumnOfBothFiles) {
  const auto columns = rollout_columns(test::scenario_of("obstacle_pass"));
  const std::string text = columns_csv({{"errors.csv", error_columns()}, {"rollout_*.csv", columns}});
  EXPECT_THAT(text, testing::StartsWith("file,name,unit,meaning\n"));
  for (const std::string& name : test::Csv(errors_csv({})).header) {
    EXPECT_THAT(text, testing::HasSubstr("errors.csv," + name + ",")) << name;
  }
  for (const Column& column : columns) {
    EXPECT_THAT(text, testing::HasSubstr("rollout_*.csv," + column.name + "," + column.unit + ",\""))
        << column.name;
    EXPECT_NE(column.meaning, "") << column.name;
  }
}

}  // namespace error_report_test
}  // namespace armtune::internal
