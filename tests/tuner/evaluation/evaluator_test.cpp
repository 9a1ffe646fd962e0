#include "tuner/evaluation/evaluator.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <ratio>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/search/tune.hpp"

namespace armtune::internal {
namespace evaluator_test {

using test::refused_at;

class Recall : public testing::Test {
 protected:
  std::unique_ptr<Journal> begin() { return Journal::begin(files_ / "journal.txt", {}); }
  std::unique_ptr<Journal> resume() {
    std::string warning;
    return Journal::resume(files_ / "journal.txt", {}, warning);
  }

  static std::vector<Evaluation> next(Evaluator& evaluator, const char* phase,
                                      const std::vector<std::vector<double>>& points) {
    std::vector<Candidate> candidates;
    for (const auto& x : points) candidates.push_back({phase, x});
    std::vector<Evaluation> taken;
    EXPECT_TRUE(evaluator.next(candidates, {},
                               [&taken](const char*, Evaluation e) { taken.push_back(std::move(e)); }));
    return taken;
  }

  test::ShortStudy files_;
  Study study_ = load_study(files_.path());
  std::atomic<bool> stop_{false};
};

TEST_F(Recall, WhatIsInTheJournalIsNotSimulatedAgain) {
  const std::vector<std::vector<double>> points = {{0.2, 0.3}, {0.5, 0.5}, {0.9, 0.1}};
  CandidateRunner workers(study_.scenarios, study_.stepper, 2);
  std::vector<Evaluation> first;
  {
    const auto journal = begin();
    Evaluator evaluator(study_, workers, stop_, journal.get());
    first = next(evaluator, "sweep", {points[0], points[1]});
  }
  EXPECT_EQ(workers.rollouts_done(), 4);
  CandidateRunner fresh(study_.scenarios, study_.stepper, 2);
  const auto journal = resume();
  Evaluator evaluator(study_, fresh, stop_, journal.get());
  const auto again = next(evaluator, "sweep", points);
  EXPECT_EQ(fresh.rollouts_done(), 2) << "only the third point is new";
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(again[i].recalled);
    EXPECT_EQ(again[i].x, first[i].x);
    EXPECT_NEAR(again[i].seconds, first[i].seconds, 0.001);
    for (std::size_t s = 0; s < study_.scenarios.size(); ++s) {
      EXPECT_EQ(test::bits(again[i].results[s].metrics), test::bits(first[i].results[s].metrics));
    }
  }
  EXPECT_FALSE(again[2].recalled);
  EXPECT_EQ(journal->records(), 3U);
}

TEST_F(Recall, AnotherPointThanRecordedIsRefused) {
  CandidateRunner workers(study_.scenarios, study_.stepper, 1);
  {
    const auto journal = begin();
    Evaluator evaluator(study_, workers, stop_, journal.get());
    next(evaluator, "search", {{0.25, 0.75}});
  }
  const auto journal = resume();
  Evaluator evaluator(study_, workers, stop_, journal.get());
  const auto another_point = [&] { next(evaluator, "search", {{0.25, std::nextafter(0.75, 1.0)}}); };
  EXPECT_THAT(
      another_point,
      refused_at(
          {.file = study_.source, .key = "evaluation 0", .value = "", .limit = "the point in the journal"}));
  const auto another_phase = [&] { next(evaluator, "global", {{0.25, 0.75}}); };
  EXPECT_THAT(
      another_phase,
      refused_at({.file = study_.source, .key = "evaluation 0", .value = "global", .limit = "search"}));
}

TEST_F(Recall, TheTimeIsUpWhereItWas) {
  study_.max_evaluations = 100000;
  study_.solver.x_tolerance = 0.0;
  CandidateRunner workers(study_.scenarios, study_.stepper, 1);
  // Time for some ten evaluations, on whatever machine.
  const auto began = std::chrono::steady_clock::now();
  workers.run({&study_.space.start, 1}, stop_);
  study_.max_minutes =
      std::chrono::duration<double, std::ratio<60>>(10.0 * (std::chrono::steady_clock::now() - began))
          .count();
  TuneResult whole;
  {
    const auto journal = begin();
    whole = tune(study_, workers, stop_, {}, journal.get());
    ASSERT_TRUE(journal->time_was_up().has_value());
    EXPECT_EQ(*journal->time_was_up(), static_cast<std::uint64_t>(whole.evaluations));
  }
  ASSERT_GT(whole.evaluations, 1);
  CandidateRunner fresh(study_.scenarios, study_.stepper, 1);
  const auto journal = resume();
  const TuneResult again = tune(study_, fresh, stop_, {}, journal.get());
  EXPECT_EQ(again.evaluations, whole.evaluations) << "although no minute has passed";
  EXPECT_EQ(again.best.x, whole.best.x);
  EXPECT_EQ(again.best.objective, whole.best.objective);
  EXPECT_EQ(fresh.rollouts_done(), 0);
}

TEST_F(Recall, ABatchEndsSoonAfterTheTimeIsUp) {
  study_.max_minutes = 1e-6;
  CandidateRunner workers(study_.scenarios, study_.stepper, 2);
  const auto journal = begin();
  Evaluator evaluator(study_, workers, stop_, journal.get());
  std::vector<Candidate> candidates;
  for (int i = 0; i < 20; ++i) candidates.push_back({"search", {0.05 * i, 0.5}});
  std::size_t taken = 0;
  EXPECT_TRUE(evaluator.next(candidates, {}, [&taken](const char*, const Evaluation&) { ++taken; }));
  EXPECT_EQ(taken, 8U) << "a portion, whatever the number of workers";
  EXPECT_EQ(journal->time_was_up(), 8U);
  EXPECT_EQ(journal->records(), 8U);
}

TEST_F(Recall, ABatchOfManyWorkersEndsWhereItDidWithFewer) {
  study_.max_minutes = 1e-6;
  std::vector<Candidate> candidates;
  for (int i = 0; i < 20; ++i) candidates.push_back({"search", {0.05 * i, 0.5}});
  std::size_t taken = 0;
  const auto count = [&taken](const char*, const Evaluation&) { ++taken; };
  {
    CandidateRunner workers(study_.scenarios, study_.stepper, 6);
    const auto journal = begin();
    EXPECT_TRUE(Evaluator(study_, workers, stop_, journal.get()).next(candidates, {}, count));
    EXPECT_EQ(taken, 12U) << "two for each worker";
    EXPECT_EQ(journal->time_was_up(), 12U);
  }
  taken = 0;
  CandidateRunner one(study_.scenarios, study_.stepper, 1);
  const auto journal = resume();
  EXPECT_TRUE(Evaluator(study_, one, stop_, journal.get()).next(candidates, {}, count));
  EXPECT_EQ(taken, 12U);
  EXPECT_EQ(one.rollouts_done(), 0);
}

TEST_F(Recall, MinutesOfEarlierSessionsCount) {
  study_.max_minutes = 1.0;
  CandidateRunner workers(study_.scenarios, study_.stepper, 1);
  {
    const auto journal = begin();
    journal->append(
        {0, "start", 59.0, study_.space.start_point(), std::vector<RolloutResult>(study_.scenarios.size())});
    EXPECT_TRUE(Evaluator(study_, workers, stop_, journal.get()).time_left());
    journal->append(
        {1, "search", 61.0, study_.space.start_point(), std::vector<RolloutResult>(study_.scenarios.size())});
  }
  const auto journal = resume();
  Evaluator evaluator(study_, workers, stop_, journal.get());
  EXPECT_TRUE(evaluator.time_left()) << "what is recorded was begun in time";
  next(evaluator, "start", {study_.space.start_point()});
  next(evaluator, "search", {study_.space.start_point()});
  EXPECT_FALSE(evaluator.time_left());
  EXPECT_EQ(journal->time_was_up(), 2U);
}

TEST_F(Recall, ASearchLeavesTheTimeThatIsKept) {
  study_.max_minutes = 1.0;
  CandidateRunner workers(study_.scenarios, study_.stepper, 1);
  const std::vector<double> x = study_.space.start_point();
  const std::vector<RolloutResult> results(study_.scenarios.size());
  {
    const auto journal = begin();
    journal->append({0, "start", 49.0, x, results});
  }
  {
    const auto journal = resume();
    Evaluator evaluator(study_, workers, stop_, journal.get());
    next(evaluator, "start", {x});
    evaluator.use(Minutes::kSearch, 5.0);
    EXPECT_TRUE(evaluator.time_left()) << "49 s of 55";
    evaluator.use(Minutes::kSearch, 11.0);
    EXPECT_FALSE(evaluator.time_left()) << "49 s of 49";
    EXPECT_TRUE(evaluator.time_was_up());
    evaluator.use(Minutes::kRun);
    EXPECT_TRUE(evaluator.time_left()) << "49 s of 60";
    EXPECT_FALSE(evaluator.time_was_up());
    journal->append({1, "verify", 61.0, x, results});
  }
  {
    const auto journal = resume();
    Evaluator evaluator(study_, workers, stop_, journal.get());
    next(evaluator, "start", {x});
    next(evaluator, "verify", {x});
    EXPECT_FALSE(evaluator.time_left());
    EXPECT_EQ(journal->time_was_up(Minutes::kSearch), 1U);
    EXPECT_EQ(journal->time_was_up(Minutes::kRun), 2U);
  }
  // Gone on with, each ends where it did, whatever is kept now.
  const auto journal = resume();
  Evaluator evaluator(study_, workers, stop_, journal.get());
  evaluator.use(Minutes::kSearch, 0.0);
  EXPECT_TRUE(evaluator.time_left());
  next(evaluator, "start", {x});
  EXPECT_FALSE(evaluator.time_left());
  evaluator.use(Minutes::kRun);
  EXPECT_TRUE(evaluator.time_left());
  next(evaluator, "verify", {x});
  EXPECT_FALSE(evaluator.time_left());
}

}  // namespace evaluator_test
}  // namespace armtune::internal
