#include "tuner/evaluation/evaluations_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <sstream>

#include "sim/csv/text_file.hpp"
#include "sim/rollout/error_report.hpp"
#include "tests/sim/support/csv.hpp"
#include "tests/sim/support/read_back.hpp"
#include "tests/tuner/support/short_study.hpp"

namespace armtune::internal {
namespace evaluations_file_test {

/// A short study whose start was "simulated" by hand.
class Journalled : public testing::Test {
 protected:
  Journalled() : study_(load_study(files_.path())) {
    e_.gains = study_.space.start;
    for (const Scenario& s : study_.scenarios) {
      RolloutResult r;
      r.end_time = s.duration;
      for (double& v : r.metrics.value) v = 1.0 / 3.0;
      e_.results.push_back(r);
    }
  }
  Objective objective() const {
    return {study_.terms, study_.constraints, study_.scenarios, e_.results, "study"};
  }

  const test::ShortStudy files_;
  Study study_;
  Evaluation e_;
};

TEST_F(Journalled, EveryRowIsOnDiskAtOnceAndHasACellPerColumn) {
  const Objective objective = this->objective();
  const std::string path = files_ / "evaluations.csv";
  EvaluationsFile journal(path, study_);
  EXPECT_EQ(test::read_csv(path).rows.size(), 0U);
  for (std::size_t i = 0; i < 3; ++i) {
    objective.judge(e_);
    e_.seconds = 0.25;
    journal.append("search", e_);
    const auto csv = test::read_csv(path);
    ASSERT_EQ(csv.rows.size(), i + 1);
    EXPECT_EQ(csv.rows[i].size(), csv.header.size());
    EXPECT_EQ(csv.at(i, "evaluation"), std::to_string(i));
  }
  const auto csv = test::read_csv(path);
  EXPECT_EQ(csv.at(0, "phase"), "search");
  EXPECT_EQ(csv.at(0, "feasible"), "1");
  EXPECT_EQ(csv.header.back(), "time/wall");
  EXPECT_EQ(std::stod(csv.at(0, "short_realistic/error/orientation/rms")), 1.0 / 3.0) << "to the bit";
}

TEST_F(Journalled, AValueThatThereIsNotIsAnEmptyCell) {
  const Objective objective = this->objective();
  EvaluationsFile journal(files_ / "evaluations.csv", study_);
  e_.results[0].status = RolloutStatus::kDiverged;
  e_.results[0].reason = "diverged at 1 s in leaveSingularity: \"elbow\" is not finite";
  e_.results[0].metrics = {};
  objective.judge(e_);
  journal.append("search", e_);
  const auto csv = test::read_csv(files_ / "evaluations.csv");
  ASSERT_EQ(csv.rows.size(), 1U);
  EXPECT_EQ(csv.rows[0].size(), csv.header.size());
  EXPECT_EQ(csv.at(0, "short/error/orientation/rms"), "");
  EXPECT_THAT(csv.at(0, "status"), testing::HasSubstr("leaveSingularity"));
  EXPECT_EQ(csv.at(0, "feasible"), "0");
}

TEST_F(Journalled, ReadsBackToTheBit) {
  const std::string path = files_ / "evaluations.csv";
  const std::vector<ExtraColumn> extra = {{{"a, \"criterion\"", "1", "", {}}, [](const Evaluation& e) {
                                             return e.seconds > 1.0 ? NAN : 1.0 / 3.0;
                                           }}};
  EvaluationsFile journal(path, study_, extra);
  std::vector<Evaluation> all(4, e_);
  for (std::size_t k = 0; k < all.size(); ++k) {
    Evaluation& e = all[k];
    e.engine = k == 1 ? Engine::kNative : Engine::kSimbody;
    e.objective = test::awkward(k);
    e.violation = test::awkward(k + 1);
    e.feasible = k == 0;
    e.completed = k == 0;
    e.reason = k == 0 ? "" : k == 1 ? test::kAwkwardText : test::kFormula;
    e.seconds = 0.75 * static_cast<double>(k) + 1e-5;
    for (const Parameter& p : study_.space.free) value(e.gains, p.entry) = test::awkward(k + 2);
    for (std::size_t m = 0; m < kMetricCount; ++m)
      e.results[0].metrics.value[m] = (m + k) % 2 == 0 ? test::no_figures()[k] : test::awkward(m + k);
  }
  for (const Evaluation& e : all) journal.append("search", e);
  test::ReadBack read(test::read_text(path));
  for (std::size_t row = 0; row < all.size(); ++row) {
    const Evaluation& e = all[row];
    read.text(row, "evaluation", std::to_string(row));
    read.text(row, "phase", "search");
    read.text(row, "engine", name(e.engine));
    read.number(row, "objective", e.objective);
    read.text(row, "feasible", e.feasible ? "1" : "0");
    read.number(row, "violation", e.violation);
    read.text(row, "status", e.completed ? "completed" : e.reason);
    for (const Parameter& p : study_.space.free) read.number(row, p.entry.name, value(e.gains, p.entry));
    const auto metrics = [&](const std::string& before, Metric m, const std::vector<std::size_t>& of) {
      for (const std::size_t s : of)
        read.number(row, before + study_.scenarios[s].name + "/" + name(m), e.results[s].metrics[m]);
    };
    for (const ObjectiveTerm& term : study_.terms) metrics("", term.metric, term.scenarios);
    for (const Constraint& c : study_.constraints) metrics("constraint/", c.metric, c.scenarios);
    read.number(row, "a, \"criterion\"", row > 1 ? NAN : 1.0 / 3.0);
    read.text(row, "time/wall", fmt::format("{:.3f}", e.seconds));
  }
  read.expect_all_seen(all.size());
}

TEST_F(Journalled, NeverWritesOverAnotherJournal) {
  files_.write("evaluations.csv", "of another run\n");
  const Objective objective = this->objective();
  EXPECT_THAT([&] { EvaluationsFile(files_ / "evaluations.csv", study_); },
              test::refused_at({.file = files_ / "evaluations.csv"}));
  EXPECT_EQ(test::read_text(files_ / "evaluations.csv"), "of another run\n");
}

TEST_F(Journalled, WhatReplacesAnotherIsPrivateAndNotWrittenThroughALink) {
  const std::string path = files_.write("evaluations.csv", "older\n");
  const std::string victim = files_.write("victim", "precious\n");
  std::filesystem::create_symlink(victim, partial_path(path));
  EvaluationsFile journal(path, study_, {}, AppendFile::Open::kReplace);
  EXPECT_EQ(test::read_text(path), "older\n");
  objective().judge(e_);
  journal.append("search", e_);
  EXPECT_EQ(test::read_text(victim), "precious\n");
  EXPECT_FALSE(std::filesystem::is_symlink(path));
  EXPECT_EQ(test::read_csv(path).rows.size(), 1U);
}

TEST(Columns, AFigureThatSeveralTermsShareIsWrittenOnce) {
  Study study = load_study("ur10_gaze");
  const std::size_t before = evaluation_columns(study).size();
  study.terms.push_back(study.terms.front());
  study.constraints.push_back(study.constraints.front());
  EXPECT_EQ(evaluation_columns(study).size(), before);
}

TEST(Columns, OfTheBundledStudyAreAllExplained) {
  const Study study = load_study("ur10_gaze");
  const std::string columns = columns_csv(
      {{"rollout_*.csv", rollout_columns(study.scenarios)}, {"evaluations.csv", evaluation_columns(study)}});
  for (const Scenario& scenario : study.scenarios) {
    for (const Column& c : rollout_columns(scenario)) {
      EXPECT_THAT(columns, testing::HasSubstr("rollout_*.csv," + c.name + ",")) << scenario.name;
    }
  }
  EXPECT_THAT(columns, testing::HasSubstr("rollout_*.csv,obstacle/distance,"));
  EXPECT_THAT(columns, testing::HasSubstr("evaluations.csv,task_space_gains_p/rx,"));
}

}  // namespace evaluations_file_test
}  // namespace armtune::internal
