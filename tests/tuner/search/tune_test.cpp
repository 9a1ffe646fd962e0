#include "tuner/search/tune.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/journal/evaluations_file.hpp"

namespace armtune {
namespace {

using test::ShortStudy;

struct Tuned {
  TuneResult result;
  std::string journal;  ///< text of evaluations.csv
  std::vector<Evaluation> evaluations;
};

/// Runs the study with a journal, looking at the file after every callback.
Tuned run(const Study& study, int workers, const std::string& journal_path, std::atomic<bool>* stop = nullptr,
          long stop_after = 0) {
  std::atomic<bool> never{false};
  std::atomic<bool>& flag = stop != nullptr ? *stop : never;
  Workers pool(study.scenarios, study.stepper, workers);
  std::unique_ptr<EvaluationsFile> journal;
  Tuned tuned;
  TuneCallbacks callbacks;
  callbacks.begin = [&](const Objective&) {
    journal = std::make_unique<EvaluationsFile>(journal_path, study);
  };
  callbacks.evaluated = [&](const char* phase, const Evaluation& e) {
    journal->append(phase, e);
    tuned.evaluations.push_back(e);
    const std::string text = test::read_text(journal_path);
    const auto rows = std::count(text.begin(), text.end(), '\n') - 1;
    EXPECT_EQ(static_cast<std::size_t>(rows), tuned.evaluations.size()) << "the row is on disk at once";
    if (stop_after > 0 && static_cast<long>(tuned.evaluations.size()) == stop_after) flag = true;
  };
  tuned.result = tune(study, pool, flag, callbacks);
  tuned.journal = test::read_text(journal_path);
  return tuned;
}

/// The text without the last column of each line: the times.
std::string without_times(const std::string& text) {
  std::istringstream lines(text);
  std::string out;
  for (std::string line; std::getline(lines, line);) out += line.substr(0, line.rfind(',')) + "\n";
  return out;
}

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
  Workers workers(study.scenarios, study.stepper, 2);
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

TEST(Tune, InterruptedItGivesTheBestSoFar) {
  const ShortStudy files;
  const Study study = load_study(files.path());
  std::atomic<bool> stop{false};
  const Tuned tuned = run(study, 2, files / "evaluations.csv", &stop, 4);
  EXPECT_TRUE(tuned.result.interrupted);
  EXPECT_EQ(tuned.result.reason, "interrupted");
  ASSERT_EQ(tuned.evaluations.size(), 4U);
  EXPECT_EQ(tuned.result.evaluations, 4);
  for (const Evaluation& e : tuned.evaluations) EXPECT_FALSE(better(e, tuned.result.best));
}

TEST(Tune, StoppedBeforeItBeganItHasNothing) {
  const ShortStudy files;
  const Study study = load_study(files.path());
  std::atomic<bool> stop{true};
  Workers workers(study.scenarios, study.stepper, 1);
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
  Workers workers(study.scenarios, study.stepper, 2);
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
  EXPECT_TRUE(std::is_sorted(phases.begin() + 1, phases.end(), std::greater<>())) << "sweep, then search";
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
  const double start = largest_velocity_ratio(whole.evaluations[0]);
  const double fastest = largest_velocity_ratio(whole.evaluations.at(2));
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
      EXPECT_THAT(e.status, testing::HasSubstr("beyond repair"));
      EXPECT_THAT(one.journal, testing::HasSubstr(e.status));
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

/// The short study with this search, and whatever keys follow.
Study searched(const ShortStudy& files, const std::string& search) {
  const std::string text = test::read_text(files.path());
  return load_study(files.write("searched.yaml", text.substr(0, text.find("search:")) + search));
}

std::vector<std::string> phases(const std::string& journal) {
  std::vector<std::string> all;
  std::istringstream lines(journal);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    const auto begin = line.find(',') + 1;
    all.push_back(line.substr(begin, line.find(',', begin) - begin));
  }
  return all;
}

TEST(Tune, GivesTheSameJournalForAnyNumberOfWorkersWhateverTheSearchIs) {
  const ShortStudy files;
  int run_number = 0;
  for (const char* search :
       {"search: {algorithm: SLSQP, max_evaluations: 9}\n", "search: {starts: 3, max_evaluations: 11}\n",
        "search: {global: ISRES, algorithm: BOBYQA, constraints: penalty, max_evaluations: 14}\n",
        "search: {algorithm: CRS2, constraints: penalty, starts: 2, max_evaluations: 13}\n"}) {
    const Study study = searched(files, search);
    const std::string name = std::to_string(run_number++);
    const Tuned one = run(study, 1, files / (name + "_one.csv"));
    const Tuned three = run(study, 3, files / (name + "_three.csv"));
    EXPECT_EQ(without_times(one.journal), without_times(three.journal)) << search;
    EXPECT_EQ(one.result.evaluations, study.max_evaluations) << search;
    EXPECT_EQ(one.result.reason, three.result.reason);
    for (const Evaluation& e : one.evaluations) EXPECT_FALSE(better(e, one.result.best));
  }
}

TEST(Tune, PointsThatFormDerivativesCountAndAreMarkedInTheJournal) {
  const ShortStudy files;
  const Tuned tuned =
      run(searched(files, "search: {algorithm: SLSQP, max_evaluations: 8}\n"), 2, files / "evaluations.csv");
  const auto names = phases(tuned.journal);
  ASSERT_EQ(names.size(), 8U);
  // The start is known: its derivatives take one point per gain.
  EXPECT_THAT((std::vector<std::string>(names.begin(), names.begin() + 4)),
              testing::ElementsAre("start", "gradient", "gradient", "search"));
  for (std::size_t g = 1; g < 3; ++g) {
    const auto& x = tuned.evaluations[g].x;
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(std::abs(x[i] - tuned.result.start.x[i]), i + 1 == g ? 0.01 : 0.0, 1e-12);
    }
  }
}

TEST(Tune, StartsTakeTurns) {
  const ShortStudy files;
  const Study study = searched(files, "search: {algorithm: SLSQP, starts: 3, max_evaluations: 16}\n");
  const Tuned tuned = run(study, 2, files / "evaluations.csv");
  // First round: derivatives at the start, which is known; then each other start with its derivatives.
  EXPECT_THAT(phases(tuned.journal),
              testing::ElementsAre("start", "gradient", "gradient", "search", "gradient", "gradient",
                                   "search", "gradient", "gradient", testing::_, testing::_, testing::_,
                                   testing::_, testing::_, testing::_, testing::_));
  EXPECT_NE(tuned.evaluations[3].x, tuned.evaluations[6].x);
}

TEST(Tune, AGlobalSearchTakesItsShareAndTheLocalOneBeginsAtTheBestPoint) {
  const ShortStudy files;
  const Study study = searched(files,
                               "search: {global: CRS2, global_share: 0.5, algorithm: COBYLA, constraints: "
                               "penalty, max_evaluations: 21}\n");
  const Tuned tuned = run(study, 2, files / "evaluations.csv");
  const auto names = phases(tuned.journal);
  ASSERT_EQ(names.size(), 21U);
  EXPECT_EQ(std::count(names.begin(), names.end(), "global"), 10) << "half of the 20 that the start leaves";
  EXPECT_EQ(names[10], "global");
  EXPECT_EQ(names[11], "search");
  const auto best = std::min_element(tuned.evaluations.begin(), tuned.evaluations.begin() + 11, better);
  // A local search begins with steps along single gains.
  const auto& first = tuned.evaluations[11].x;
  EXPECT_EQ((first[0] != best->x[0]) + (first[1] != best->x[1]), 1);
}

TEST(Tune, AWarmStartBeginsThereKeepsToItsBoxAndStaysRelativeToTheStart) {
  const ShortStudy files;
  Study study = load_study(files.path());
  study.warm.emplace();
  study.warm->gains = study.space.start;
  study.warm->gains.task_space_gains_p[3] = 45.0;
  study.warm->box = 0.2;
  study.warm->step = 0.05;
  const WarmPoint point = warm_point(study.space, *study.warm);
  const Tuned tuned = run(study, 2, files / "evaluations.csv");
  const auto names = phases(tuned.journal);
  EXPECT_EQ(tuned.result.start.objective, 1.0);
  ASSERT_GE(names.size(), 4U);
  EXPECT_EQ(names[0], "start");
  EXPECT_EQ(names[1], "warm");
  EXPECT_EQ(tuned.evaluations[0].x, study.space.start_point());
  EXPECT_EQ(tuned.evaluations[1].x, point.x);
  EXPECT_EQ(names[2], "search");
  for (std::size_t e = 1; e < tuned.evaluations.size(); ++e) {
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_GE(tuned.evaluations[e].x[i], point.lower[i]);
      EXPECT_LE(tuned.evaluations[e].x[i], point.upper[i]);
    }
  }
  const auto& first = tuned.evaluations[2].x;
  EXPECT_NEAR(std::max(std::abs(first[0] - point.x[0]), std::abs(first[1] - point.x[1])), 0.05, 1e-9);
}

}  // namespace
}  // namespace armtune
