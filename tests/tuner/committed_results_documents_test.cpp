// The tables of the documents hold the figures of results/, and a simulation gives these again.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "sim/rollout/rollout.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/sim/support/csv.hpp"

namespace armtune::internal {
namespace committed_results_documents_test {

const std::string kRoot = test::source_dir();

/// README, NOTATION and every page of docs/.
std::vector<std::string> documents() {
  std::vector<std::string> paths = {kRoot + "/README.md", kRoot + "/NOTATION.md"};
  for (const auto& entry : std::filesystem::directory_iterator(kRoot + "/docs")) {
    if (entry.path().extension() == ".md") paths.push_back(entry.path().string());
  }
  return paths;
}

/// Cells of a row of a table in Markdown, without blanks around them and without backticks.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '|' && (i == 0 || line[i - 1] != '\\')) {
      cells.emplace_back();
    } else if (!cells.empty() && line[i] != '`') {
      cells.back() += line[i];
    }
  }
  if (!cells.empty()) cells.pop_back();
  for (std::string& cell : cells) {
    cell.erase(0, cell.find_first_not_of(' '));
    cell.erase(cell.find_last_not_of(' ') + 1);
  }
  return cells;
}

/// Rows of all tables of a document that have this header.
std::vector<std::vector<std::string>> rows_below(const std::string& path, const std::string& header) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(test::read_text(path));
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line == header) {
      inside = true;
      std::getline(lines, line);
    } else if (inside && line.starts_with("|")) {
      rows.push_back(cells_of(line));
    } else {
      inside = false;
    }
  }
  return rows;
}

/// results/ablation/ablation.csv: a value for each gain set, theta, scenario and metric.
class CommittedComparison : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    values_ = new std::map<std::string, double>();
    const auto csv = test::read_csv(kRoot + "/results/ablation/ablation.csv");
    for (std::size_t row = 0; row < csv.rows.size(); ++row) {
      if (csv.at(row, "status") != "completed") continue;
      const std::string metric = csv.at(row, "metric") + " [" + csv.at(row, "unit") + "]";
      (*values_)[csv.at(row, "variant") + csv.at(row, "theta") + csv.at(row, "scenario") + metric] =
          std::stod(csv.at(row, "value"));
    }
  }
  static void TearDownTestSuite() { delete values_; }

  /// NaN where there is none.
  static double value(const std::string& gains, const std::string& theta, const std::string& scenario,
                      const std::string& metric) {
    const auto found =
        values_->find((gains == "published" ? gains : "all tuned") + theta + scenario + metric);
    return found == values_->end() ? NAN : found->second;
  }
  static void expect_figures(const std::vector<std::string>& row, double before, double now) {
    const std::string which = row[0] + ", " + row[1] + ", " + row[2];
    EXPECT_EQ(row[3], fmt::format("{:.3g}", before)) << which;
    EXPECT_EQ(row[4], fmt::format("{:.3g}", now)) << which;
    EXPECT_EQ(row[5], fmt::format("{:.3g}", before / now)) << which;
  }

  static std::map<std::string, double>* values_;
};

std::map<std::string, double>* CommittedComparison::values_ = nullptr;

TEST_F(CommittedComparison, EveryRowOfTheDocumentsComparesTwoGainSetsFromTheSameTheta) {
  bool camera = false;
  std::size_t rows = 0;
  for (const std::string& path : documents()) {
    for (const auto& row : rows_below(
             path, "| scenario | theta of both | error | published | extended, tuned | times smaller |")) {
      ASSERT_EQ(row.size(), 6U) << path;
      expect_figures(row, value("published", row[1], row[0], row[2]),
                     value("extended, tuned", row[1], row[0], row[2]));
      camera = camera || row[0].find("camera") != std::string::npos;
      ++rows;
    }
  }
  EXPECT_GE(rows, 36U) << "docs/comparisons.md has nine scenarios, two thetas and two errors";
  EXPECT_TRUE(camera);
}

TEST_F(CommittedComparison, WhatTheIdentifiedThetaGivesStandsInRowsOfItsOwn) {
  std::size_t rows = 0;
  for (const std::string& path : documents()) {
    for (const auto& row : rows_below(
             path,
             "| scenario | gains | error | theta of the scenario | identified theta | times smaller |")) {
      ASSERT_EQ(row.size(), 6U) << path;
      expect_figures(row, value(row[1], "scenario", row[0], row[2]),
                     value(row[1], "identified", row[0], row[2]));
      ++rows;
    }
  }
  EXPECT_GE(rows, 36U);
}

TEST_F(CommittedComparison, HoldsTheFiguresThatASimulationGivesAgain) {
  const std::map<std::string, std::string> files = {{"published", "published"},
                                                    {"extended, tuned", "extended_tuned"}};
  for (const std::string theta : {"scenario", "identified"}) {
    const Scenario scenario =
        load_scenario((theta == "identified" ? "identified_" : "") + std::string("realistic_moving_target"));
    for (const auto& [gains, file] : files) {
      const RolloutResult now = Rollout(scenario, Stepper::kMidpoint, Engine::kNative)
                                    .run(load_gains(file, joint_names(*scenario.robot)));
      for (const Metric m : {Metric::kOrientationMax, Metric::kPositionMax}) {
        const double committed =
            value(gains, theta, "realistic_moving_target", std::string(name(m)) + " [" + field(m).unit + "]");
        EXPECT_NEAR(now.metrics[m], committed, 1e-3 * committed) << gains << ' ' << theta << ' ' << name(m);
      }
    }
  }
}

TEST(CommittedReproduction, TheDocumentsSayHowFarTheReportsPeaksAreFromOurs) {
  const auto csv = test::read_csv(kRoot + "/results/reproduction/reproduction.csv");
  std::map<std::string, std::size_t> row_of;
  for (std::size_t row = 0; row < csv.rows.size(); ++row) row_of[csv.at(row, "variant")] = row;
  const auto rows = rows_below(
      kRoot + "/docs/comparisons.md",
      "| variant | position [m] | orientation [rad] | report over position | report over orientation |");
  ASSERT_EQ(rows.size(), csv.rows.size());
  for (const auto& row : rows) {
    ASSERT_EQ(row.size(), 5U);
    ASSERT_EQ(row_of.count(row[0]), 1U) << row[0];
    const std::size_t at = row_of[row[0]];
    EXPECT_EQ(row[1], fmt::format("{:.2g}", std::stod(csv.at(at, "position")))) << row[0];
    EXPECT_EQ(row[2], fmt::format("{:.2g}", std::stod(csv.at(at, "orientation")))) << row[0];
    EXPECT_EQ(row[3], fmt::format("{:.2g}", std::stod(csv.at(at, "report_over_position")))) << row[0];
    EXPECT_EQ(row[4], fmt::format("{:.2g}", std::stod(csv.at(at, "report_over_orientation")))) << row[0];
  }
  const Scenario scenario = load_scenario("moving_target");
  const RolloutResult now = Rollout(scenario, Stepper::kMidpoint, Engine::kNative)
                                .run(load_gains("published", joint_names(*scenario.robot)));
  const auto largest = [&now](Metric x, Metric y, Metric z) {
    return std::max({now.metrics[x], now.metrics[y], now.metrics[z]});
  };
  const std::size_t bundled = row_of["as bundled"];
  const double position = std::stod(csv.at(bundled, "position"));
  const double orientation = std::stod(csv.at(bundled, "orientation"));
  EXPECT_NEAR(largest(Metric::kPositionXMax, Metric::kPositionYMax, Metric::kPositionZMax), position,
              1e-3 * position);
  EXPECT_NEAR(largest(Metric::kOrientationXMax, Metric::kOrientationYMax, Metric::kOrientationZMax),
              orientation, 1e-3 * orientation);
}

TEST(Notation, HasARowForEachOfTheReportsTenEquations) {
  const auto rows =
      rows_below(kRoot + "/NOTATION.md", "| eq. | the report | read as | deviates from the report |");
  ASSERT_EQ(rows.size(), 10U);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), 4U) << i;
    EXPECT_EQ(rows[i][0], std::to_string(i + 1));
    for (const std::string& cell : rows[i]) EXPECT_FALSE(cell.empty()) << i + 1;
  }
}

}  // namespace committed_results_documents_test
}  // namespace armtune::internal
