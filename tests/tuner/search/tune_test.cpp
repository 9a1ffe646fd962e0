#include "tuner/search/tune.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <sstream>

#include "tests/tuner/support/tuned.hpp"

namespace armtune::internal {
namespace tune_test {

using test::run;
using test::ShortStudy;
using test::Tuned;
using test::without_times;

TEST(Tune, GivesTheSameJournalForAnyNumberOfWorkers) {
  const ShortStudy files;
  const Study study = load_study(files.path());
  const Tuned one = run(study, 1, files / "one.csv");
  const Tuned two = run(study, 2, files / "two.csv");
  EXPECT_NE(one.journal, two.journal) << "the times differ";
  EXPECT_EQ(without_times(one.journal), without_times(two.journal));
  EXPECT_EQ(one.result.best.x, two.result.best.x);
  EXPECT_EQ(one.result.best.objective, two.result.best.objective);
}

TEST(Tune, JournalsEveryEvaluationAndKeepsTheBestOfThem) {
  const ShortStudy files;
  const Study study = load_study(files.path());
  const Tuned tuned = run(study, 2, files / "evaluations.csv");
  ASSERT_FALSE(tuned.evaluations.empty());
  EXPECT_EQ(tuned.result.evaluations, static_cast<long>(tuned.evaluations.size()));
  EXPECT_LE(tuned.result.evaluations, study.max_evaluations);
  EXPECT_FALSE(tuned.result.interrupted);
  EXPECT_EQ(tuned.result.start.objective, 1.0);
  EXPECT_TRUE(tuned.result.start.feasible);
  EXPECT_TRUE(tuned.result.best.feasible);
  EXPECT_LE(tuned.result.best.objective, 1.0);
  for (const Evaluation& e : tuned.evaluations) EXPECT_FALSE(better(e, tuned.result.best));
  for (std::size_t i = 0; i < tuned.evaluations.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_NE(tuned.evaluations[i].x, tuned.evaluations[j].x) << "no point is simulated twice";
    }
  }
  EXPECT_THAT(tuned.journal,
              testing::StartsWith("evaluation,phase,engine,objective,feasible,violation,status,"
                                  "task_space_gains_p/rx,slerpDurationErrorGain,"));
}

TEST(Tune, TheBestIsFeasibleIfAnyPointWas) {
  // A limit just below what the start needs: the start itself misses it.
  const ShortStudy probe;
  Study study = load_study(probe.path());
  std::atomic<bool> never{false};
  CandidateRunner workers(study.scenarios, study.stepper, 2);
  study.max_evaluations = 1;
  const TuneResult start = tune(study, workers, never, {});
  study.constraints = {{Metric::kOrientationMax, true, {}, {0, 1}}};
  study.constraints[0].limit = 0.0;
  for (const RolloutResult& r : start.start.results) {
    study.constraints[0].limit = std::max(*study.constraints[0].limit, r.metrics[Metric::kOrientationMax]);
  }
  *study.constraints[0].limit *= 0.95;
  study.max_evaluations = 12;
  const Tuned tuned = run(study, 2, probe / "evaluations.csv");
  EXPECT_FALSE(tuned.result.start.feasible);
  const bool any = std::any_of(tuned.evaluations.begin(), tuned.evaluations.end(),
                               [](const Evaluation& e) { return e.feasible; });
  EXPECT_TRUE(any) << "a stiffer wrist meets the limit";
  EXPECT_EQ(tuned.result.best.feasible, any);
}

/// A tuning in which `breaks` says, of one gain set after the other, whether it has a fault.
struct CheckedRun {
  TuneResult result;
  std::vector<Evaluation> evaluations;
  int asked = 0;
};

CheckedRun tuned_with_checks(const Study& study, const std::function<bool(int asked)>& breaks) {
  CheckedRun run;
  const std::atomic<bool> never{false};
  CandidateRunner workers(study.scenarios, study.stepper, 2);
  TuneCallbacks callbacks;
  callbacks.evaluated = [&run](const char*, const Evaluation& e) { run.evaluations.push_back(e); };
  callbacks.fault = [&](const Gains&) { return std::string(breaks(run.asked++) ? "after a minute" : ""); };
  run.result = tune(study, workers, never, callbacks);
  return run;
}

TEST(Tune, WhereTheBestHasAFaultItTurnsBackTowardsTheStart) {
  const ShortStudy files;
  const Study study = load_study(files.path());
  const CheckedRun holds = tuned_with_checks(study, [](int) { return false; });
  const Evaluation& best = holds.result.best;
  const Evaluation& start = holds.result.start;
  EXPECT_EQ(holds.asked, 1) << "of the best alone";
  EXPECT_EQ(holds.result.passed_over, "");
  ASSERT_TRUE(better(best, start));

  // The first on the way back breaks as well, the second holds.
  const CheckedRun back = tuned_with_checks(study, [](int asked) { return asked < 2; });
  EXPECT_EQ(back.asked, 3);
  ASSERT_EQ(back.evaluations.size(), holds.evaluations.size() + 2);
  for (std::size_t i = 0; i < best.x.size(); ++i) {
    EXPECT_DOUBLE_EQ(back.evaluations[back.evaluations.size() - 2].x[i],
                     start.x[i] + 0.5 * (best.x[i] - start.x[i]));
    EXPECT_DOUBLE_EQ(back.result.best.x[i], start.x[i] + 0.25 * (best.x[i] - start.x[i]));
  }
  EXPECT_TRUE(back.result.best.feasible);
  EXPECT_TRUE(better(back.result.best, start));
  EXPECT_THAT(back.result.passed_over,
              testing::AllOf(testing::HasSubstr("after a minute"), testing::HasSubstr("25 %")));

  // Nothing holds: the best stays.
  const CheckedRun never = tuned_with_checks(study, [](int) { return true; });
  EXPECT_EQ(never.result.best.x, best.x);
  EXPECT_EQ(never.result.passed_over, "");
  EXPECT_EQ(never.evaluations.size(), holds.evaluations.size() + kSharesOfTheWay.size());
}

TEST(Tune, InterruptedItGivesTheBestSoFar) {
  const ShortStudy files;
  const Study study = load_study(files.path());
  std::atomic<bool> stop{false};
  const Tuned tuned = run(study, 2, files / "evaluations.csv", &stop, 4);
  EXPECT_TRUE(tuned.result.interrupted);
  EXPECT_EQ(tuned.result.reason, "interrupted");
  EXPECT_EQ(tuned.result.ended, SearchEnd::kInterrupted);
  ASSERT_EQ(tuned.evaluations.size(), 4U);
  EXPECT_EQ(tuned.result.evaluations, 4);
  for (const Evaluation& e : tuned.evaluations) EXPECT_FALSE(better(e, tuned.result.best));
}

TEST(Tune, StoppedBeforeItBeganItHasNothing) {
  const ShortStudy files;
  const Study study = load_study(files.path());
  std::atomic<bool> stop{true};
  CandidateRunner workers(study.scenarios, study.stepper, 1);
  const TuneResult result = tune(study, workers, stop, {});
  EXPECT_TRUE(result.interrupted);
  EXPECT_EQ(result.evaluations, 0);
}

TEST(Tune, SweepsBeforeItSearchesAndRemembersTheBestOfTheSweep) {
  const ShortStudy files(test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                         "sweep:\n"
                         "  - {parameters: [task_space_gains_p/rx], factors: [0.8, 1, 2]}\n"
                         "  - {parameters: [slerpDurationErrorGain], factors: [1, 0.8]}\n"
                         "search: {max_evaluations: 9}\n");
  const Study study = load_study(files.path());
  std::atomic<bool> never{false};
  CandidateRunner workers(study.scenarios, study.stepper, 2);
  std::vector<std::string> phases;
  std::vector<Evaluation> swept;
  TuneCallbacks callbacks;
  callbacks.evaluated = [&](const char* phase, const Evaluation& e) {
    phases.emplace_back(phase);
    if (phases.back() == "sweep") swept.push_back(e);
  };
  const TuneResult result = tune(study, workers, never, callbacks);
  EXPECT_EQ(phases.front(), "start");
  EXPECT_EQ(std::count(phases.begin(), phases.end(), "start"), 1);
  const auto once = std::vector<std::string>(phases.begin(), std::unique(phases.begin(), phases.end()));
  EXPECT_THAT(once, testing::ElementsAre("start", "sweep", "global", "search"));
  ASSERT_TRUE(result.best_of_sweep.has_value());
  for (const Evaluation& e : swept) EXPECT_FALSE(better(e, *result.best_of_sweep));
  EXPECT_FALSE(better(*result.best_of_sweep, result.best));
  EXPECT_LE(result.evaluations, 9);
}

TEST(Tune, EndsHopelessRolloutsEarlyAndStillSeesTheBestOneWhole) {
  const ShortStudy files(test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                         "sweep:\n  - {parameters: [task_space_gains_p/rx], factors: [1.2, 2.2]}\n"
                         "search: {max_evaluations: 7}\n");
  Study study = load_study(files.path());
  // Beyond repair: halfway between what the start needs and the stiffest wrist of the sweep.
  const Tuned whole = run(study, 2, files / "whole.csv");
  const double start = largest_velocity_ratio(study, whole.evaluations[0]);
  const double fastest = largest_velocity_ratio(study, whole.evaluations.at(2));
  ASSERT_GT(fastest, 1.05 * start);
  const double limit = 0.75 * start + 0.25 * fastest;
  const Hopeless beyond = {Hopeless::Kind::kFrom, 0.5 * (start + fastest)};
  study.constraints = {{Metric::kJointVelocityMaxRatio, true, limit, {0, 1}, beyond}};
  const Tuned one = run(study, 1, files / "one.csv");
  const Tuned two = run(study, 2, files / "two.csv");
  EXPECT_EQ(without_times(one.journal), without_times(two.journal));

  std::size_t hopeless = 0;
  for (const Evaluation& e : one.evaluations) {
    for (const RolloutResult& r : e.results) {
      if (r.status != RolloutStatus::kHopeless) continue;
      ++hopeless;
      EXPECT_FALSE(e.feasible);
      EXPECT_FALSE(e.completed);
      EXPECT_THAT(e.reason, testing::HasSubstr("abandoned"));
      EXPECT_THAT(one.journal, testing::HasSubstr(e.reason));
      EXPECT_LT(r.end_time, study.scenarios[0].duration);
      // Simulated whole it breaks the limit all the same.
      Rollout again(study.scenarios[static_cast<std::size_t>(&r - e.results.data())], study.stepper);
      EXPECT_GE(again.run(e.gains).metrics[Metric::kJointVelocityMaxRatio], beyond.value);
    }
  }
  EXPECT_GT(hopeless, 0U);
  const Evaluation& best = one.result.best;
  ASSERT_TRUE(best.feasible);
  for (std::size_t s = 0; s < study.scenarios.size(); ++s) {
    const RolloutResult again = Rollout(study.scenarios[s], study.stepper).run(best.gains);
    EXPECT_EQ(test::bits(again.metrics), test::bits(best.results[s].metrics));
  }
}

TEST(Tune, ASweepOfWorsePointsLeavesTheStartTheBest) {
  const ShortStudy files(test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                         "sweep:\n  - {parameters: [task_space_gains_p/rx], factors: [0.5, 0.6]}\n"
                         "search: {max_evaluations: 3}\n");
  const Tuned tuned = run(load_study(files.path()), 2, files / "evaluations.csv");
  ASSERT_EQ(tuned.evaluations.size(), 3U);
  ASSERT_TRUE(tuned.result.best_of_sweep.has_value());
  EXPECT_TRUE(better(tuned.result.start, *tuned.result.best_of_sweep)) << "softer wrists look worse";
  EXPECT_EQ(tuned.result.best.x, tuned.result.start.x);
}

TEST(Tune, ABudgetThatEndsInsideTheSweepIsKeptToByAnyNumberOfWorkers) {
  const ShortStudy files(test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                         "sweep:\n  - {parameters: [task_space_gains_p/rx], factors: [0.8, 0.9, 1.1, 1.2]}\n"
                         "search: {max_evaluations: 4}\n");
  const Study study = load_study(files.path());
  const Tuned one = run(study, 1, files / "one.csv");
  const Tuned two = run(study, 2, files / "two.csv");
  EXPECT_EQ(one.result.evaluations, 4);
  EXPECT_EQ(two.result.evaluations, 4);
  EXPECT_EQ(without_times(one.journal), without_times(two.journal));
}

}  // namespace tune_test
}  // namespace armtune::internal
