#include "tuner/trade_off/pareto.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sim/support/csv.hpp"
#include "tests/sim/support/read_back.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/trade_off/pareto_file.hpp"

namespace armtune::internal {
namespace pareto_test {

const std::atomic<bool> kNever{false};

class Pareto : public ::testing::Test {
 protected:
  Pareto() : study_(load_study(files_.path())) {
    options_.criteria = {criterion_from_name("objective"), criterion_from_name("gaze/rms")};
    options_.levels = 3;
    options_.max_evaluations = 24;
  }
  ParetoResult run(int workers, const std::atomic<bool>& stop = kNever) {
    CandidateRunner pool(study_.scenarios, study_.stepper, workers);
    ParetoCallbacks callbacks;
    callbacks.begin = [this](const Objective& o) { objective_ = o; };
    callbacks.evaluated = [this](const char*, const Evaluation& e) {
      evaluations_.push_back(e);
      if (after_) after_();
    };
    return pareto(study_, options_, pool, stop, callbacks);
  }

  // Loose enough that some points keep the constraints.
  test::ShortStudy files_{test::kShortParameters, test::kShortObjective,
                          "constraints:\n  - {metric: joint_velocity/max_ratio, at_most: 2}\n"};
  Study study_;
  ParetoOptions options_;
  std::optional<Objective> objective_;
  std::vector<Evaluation> evaluations_;
  std::function<void()> after_;
};

TEST_F(Pareto, IsWhatNoFeasibleEvaluationOfTheRunDominates) {
  const ParetoResult result = run(2);
  EXPECT_LE(result.evaluations, 24);
  EXPECT_EQ(static_cast<std::size_t>(result.evaluations), evaluations_.size());
  ASSERT_GE(result.front.size(), 3U);
  for (const ParetoPoint& p : result.front) {
    EXPECT_TRUE(p.e.feasible);
    EXPECT_EQ(p.e.x, evaluations_[static_cast<std::size_t>(p.evaluation)].x) << "its number in the journal";
    for (const Evaluation& e : evaluations_) {
      const Costs costs = {cost(options_.criteria[0], e, study_.scenarios),
                           cost(options_.criteria[1], e, study_.scenarios)};
      EXPECT_FALSE(e.feasible && dominates(costs, p.costs));
    }
  }
  EXPECT_GT(result.hypervolume, 0.0);
  EXPECT_LT(result.hypervolume, 1.0);
  EXPECT_GT(result.dominating_start(), 0U);
  ASSERT_GE(result.levels.size(), 2U);
  for (const ParetoLevel& level : result.levels)
    EXPECT_LE(result.front[level.best].costs[1], level.levels[1]);
}

TEST_F(Pareto, ItsFirstEndIsSearchedAsTheStudyIsGlobalPhaseIncluded) {
  const test::ShortStudy files(test::kShortParameters, test::kShortObjective, "", "");
  study_ = load_study(files.path());
  options_.max_evaluations = 40;
  run(2);
  // DIRECT_L begins in the middle of the box, then a third of it to either side: four points of two gains.
  ASSERT_GE(evaluations_.size(), 6U);
  const std::vector<double> middle = {0.5, 0.5};
  EXPECT_EQ(evaluations_[1].x, middle);
  for (std::size_t e = 2; e < 6; ++e) {
    const auto& x = evaluations_[e].x;
    EXPECT_EQ((x[0] != 0.5) + (x[1] != 0.5), 1);
    EXPECT_NEAR(std::abs(x[0] - 0.5) + std::abs(x[1] - 0.5), 1.0 / 3.0, 1e-12);
  }
  // Then the local search, with steps from the best of them.
  const auto best = std::min_element(evaluations_.begin(), evaluations_.begin() + 6, better);
  const auto& first = evaluations_[6].x;
  EXPECT_EQ((first[0] != best->x[0]) + (first[1] != best->x[1]), 1);
  EXPECT_NEAR(std::abs(first[0] - best->x[0]) + std::abs(first[1] - best->x[1]), study_.solver.initial_step,
              1e-9);
}

TEST_F(Pareto, WithNothingFeasibleItsLocalSearchBeginsAtTheLeastViolation) {
  const test::ShortStudy files(
      test::kShortParameters, test::kShortObjective,
      "constraints:\n  - {metric: joint_velocity/max_ratio, at_most: 0.1, hopeless: never}\n", "");
  study_ = load_study(files.path());
  options_.max_evaluations = 40;
  run(2);
  ASSERT_GE(evaluations_.size(), 7U);
  const auto best = std::min_element(evaluations_.begin(), evaluations_.begin() + 6, better);
  ASSERT_FALSE(best->feasible);
  ASSERT_NE(best, evaluations_.begin()) << "the start is not the best, so that it shows";
  const auto& first = evaluations_[6].x;
  EXPECT_EQ((first[0] != best->x[0]) + (first[1] != best->x[1]), 1);
}

TEST_F(Pareto, IsTheSameForAnyNumberOfWorkersAndAgainInFreshRollouts) {
  ParetoResult one = run(1);
  const std::string text = pareto_csv(study_, options_, one);
  EXPECT_EQ(pareto_csv(study_, options_, run(3)), text);
  CandidateRunner fresh(study_.scenarios, study_.stepper, 2);
  EXPECT_TRUE(verify(study_, *objective_, options_, one, fresh, kNever));
  EXPECT_EQ(pareto_csv(study_, options_, one), text);
  one.front.back().costs[1] *= 1.0 + 1e-12;
  EXPECT_THROW(verify(study_, *objective_, options_, one, fresh, kNever), std::runtime_error);
}

TEST_F(Pareto, FoundInTheNativeEngineItsFiguresAreStillSimbodys) {
  study_.engine = Engine::kNative;
  ParetoResult result = run(2);
  CandidateRunner fresh(study_.scenarios, study_.stepper, 2);
  const auto found = result.front;
  ASSERT_GE(found.size(), 3U);
  ASSERT_TRUE(verify(study_, *objective_, options_, result, fresh, kNever));
  ASSERT_EQ(result.front.size(), found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(result.front[i].e.x, found[i].e.x);
    for (std::size_t s = 0; s < study_.scenarios.size(); ++s) {
      const auto in_engine = [&](Engine engine) {
        return test::bits(Rollout(study_.scenarios[s], study_.stepper, engine).run(found[i].e.gains).metrics);
      };
      EXPECT_EQ(test::bits(result.front[i].e.results[s].metrics), in_engine(Engine::kSimbody));
      const bool start = found[i].evaluation == 0;
      EXPECT_EQ(test::bits(found[i].e.results[s].metrics),
                in_engine(start ? Engine::kSimbody : Engine::kNative));
    }
    for (std::size_t c = 0; c < 2; ++c) {
      EXPECT_NEAR(result.front[i].costs[c], found[i].costs[c], 1e-9 * std::abs(found[i].costs[c]));
    }
  }
  result.front.back().costs[1] *= 1.01;
  EXPECT_THROW(verify(study_, *objective_, options_, result, fresh, kNever), std::runtime_error);
}

TEST_F(Pareto, ItsCsvReadsBackToTheBitAndIsEmptyWhereACriterionHasNoFigure) {
  options_.criteria = {criterion_from_name("gaze/rms"), criterion_from_name("response/bandwidth")};
  ParetoResult result;
  for (std::size_t i = 0; i < 4; ++i) {
    ParetoPoint p;
    p.evaluation = static_cast<long>(10 * i);
    p.e.gains = study_.space.start;
    p.e.objective = i == 3 ? NAN : test::awkward(i);
    p.e.results.resize(study_.scenarios.size());
    for (RolloutResult& r : p.e.results)
      for (double& v : r.metrics.value) v = i == 2 ? INFINITY : i == 3 ? NAN : test::awkward(i + 1);
    for (const Parameter& q : study_.space.free) value(p.e.gains, q.entry) = test::awkward(i + 3);
    p.costs = {1.0 + static_cast<double>(i), 1.0};
    if (i == 1) {
      result.start = p;
    } else {
      result.front.push_back(p);
    }
  }
  test::ReadBack read(pareto_csv(study_, options_, result));
  for (std::size_t row = 0; row < 4; ++row) {
    const ParetoPoint& p = row < 3 ? result.front[row] : result.start;
    read.text(row, "point", row < 3 ? std::to_string(row + 1) : "");
    read.text(row, "kind", row < 3 ? "front" : "start");
    read.text(row, "evaluation", std::to_string(p.evaluation));
    read.text(row, "dominates_start", row == 0 ? "1" : "0");
    for (const Criterion& c : options_.criteria) read.number(row, c.name(), value(c, p.e, study_.scenarios));
    read.number(row, "objective", p.e.objective);
    for (const Parameter& q : study_.space.free) read.number(row, q.entry.name, value(p.e.gains, q.entry));
  }
  read.expect_all_seen(4);
  read.text(2, "gaze/rms", "");
  read.text(2, "objective", "");
}

TEST_F(Pareto, ItsCsvGivesTheGainsOfEveryPointAndMarksTheStart) {
  const ParetoResult result = run(2);
  const test::Csv csv(pareto_csv(study_, options_, result));
  ASSERT_EQ(csv.rows.size(), result.front.size() + 1);
  for (std::size_t i = 0; i < result.front.size(); ++i) {
    EXPECT_EQ(csv.at(i, "kind"), "front");
    EXPECT_EQ(std::stod(csv.at(i, "gaze/rms")), result.front[i].costs[1]);
    for (const Parameter& p : study_.space.free) {
      EXPECT_EQ(std::stod(csv.at(i, p.entry.name)), value(result.front[i].e.gains, p.entry));
    }
  }
  EXPECT_EQ(csv.at(result.front.size(), "kind"), "start");
  EXPECT_EQ(csv.at(result.front.size(), "objective"), "1");
  std::vector<std::string> explained;
  for (const Column& c : pareto_columns(study_, options_)) explained.push_back(c.name);
  EXPECT_EQ(explained, csv.header);
}

TEST_F(Pareto, TakesThreeCriteria) {
  options_.criteria.push_back(criterion_from_name("effort_rate/rms"));
  options_.levels = 2;
  const ParetoResult result = run(2);
  ASSERT_FALSE(result.front.empty());
  EXPECT_EQ(result.front[0].costs.size(), 3U);
  EXPECT_EQ(options_.searches(), 8U);
  ASSERT_FALSE(result.levels.empty());
  for (const ParetoLevel& level : result.levels) {
    for (std::size_t k = 1; k < 3; ++k) EXPECT_LE(result.front[level.best].costs[k], level.levels[k]);
  }
}

TEST_F(Pareto, SpreadsItsLevelsAlsoIfTheStartBreaksAConstraint) {
  // Better gaze than the start's costs more effort than the start's: no feasible point is as good in both.
  options_.criteria = {criterion_from_name("effort_rate/rms"), criterion_from_name("objective")};
  options_.max_evaluations = 40;
  CandidateRunner pool(study_.scenarios, study_.stepper, 2);
  const std::vector<Gains> start = {study_.space.start};
  Constraint sharp;
  sharp.metric = Metric::kGazeRms;
  sharp.limit = 0.97 * (*pool.run(start, kNever))[0][1].metrics[Metric::kGazeRms];
  sharp.scenarios = {1};
  study_.constraints.push_back(sharp);
  const ParetoResult result = run(2);
  EXPECT_FALSE(result.start.e.feasible);
  ASSERT_GE(result.front.size(), 2U);
  ASSERT_EQ(result.levels.size(), options_.levels);
  EXPECT_LT(result.levels.back().levels[1], result.levels.front().levels[1]);
}

TEST_F(Pareto, WhatEndsTheSearchEarlyLeavesWhatItHadFound) {
  after_ = [this] {
    if (evaluations_.size() == 8) throw std::runtime_error("no space left");
  };
  const ParetoResult result = run(2);
  ASSERT_TRUE(result.failure);
  EXPECT_THROW(std::rethrow_exception(result.failure), std::runtime_error);
  EXPECT_FALSE(result.front.empty());
}

TEST_F(Pareto, AStopLeavesTheFrontSoFar) {
  std::atomic<bool> stop{false};
  after_ = [this, &stop] { stop = evaluations_.size() == 9; };
  const ParetoResult result = run(2, stop);
  EXPECT_TRUE(result.interrupted);
  EXPECT_EQ(result.evaluations, 9);
  EXPECT_FALSE(result.front.empty());
}

TEST_F(Pareto, ACriterionThatTheStartDoesNotGiveIsRefused) {
  options_.criteria[1] = criterion_from_name("obstacle/min_clearance");
  EXPECT_THAT([this] { run(2); },
              test::refused_at(
                  {.key = "obstacle/min_clearance", .value = "nan", .limit = "finite, and other than 0"}));
}

}  // namespace pareto_test
}  // namespace armtune::internal
