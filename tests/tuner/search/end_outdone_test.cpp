// Rollouts of candidates that can make no difference to the search end early: it finds what it would have
// found.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/tuner/support/tuned.hpp"
#include "tuner/search/tune.hpp"

namespace armtune {
namespace {

using test::run;
using test::ShortStudy;
using test::Tuned;
using test::without_times;

long outdone(const Tuned& tuned) {
  return std::count_if(tuned.evaluations.begin(), tuned.evaluations.end(),
                       [](const Evaluation& e) { return std::isfinite(e.beyond); });
}

std::vector<std::vector<double>> points(const Tuned& tuned) {
  std::vector<std::vector<double>> all;
  for (const Evaluation& e : tuned.evaluations) all.push_back(e.x);
  return all;
}

class EveryOutdone : public testing::TestWithParam<std::tuple<std::string, int>> {
 protected:
  std::string search() const {
    return fmt::format(
        "search: {{algorithm: {}, constraints: penalty, penalty: 1, max_evaluations: {}, engine: native, "
        "verify_share: 0.05, initial_step: 0.4}}\n",
        std::get<0>(GetParam()), std::get<1>(GetParam()));
  }
};

// Soft wrists look past the target, stiff ones go too fast: either shows before the end.
const std::string kObjective =
    "objective:\n"
    "  - {metric: error/orientation/max, weight: 3, scenarios: [short]}\n"
    "  - {metric: error/orientation/rms, weight: 0.1}\n";
const std::string kConstraints = "constraints:\n  - {metric: joint_velocity/max_ratio, at_most: 0.65}\n";

TEST_P(EveryOutdone, TheSearchFindsTheSameWithLessSimulated) {
  const ShortStudy files(test::kShortParameters, kObjective, kConstraints, search());
  // Side by side, rollouts of one length end together: then neither shows anything of the other in time.
  files.write("short_realistic.yaml", "base: realistic_moving_target\nduration: 9\n");
  Study study = load_study(files.path());
  ASSERT_TRUE(study.end_outdone) << "by default";
  const Tuned with = run(study, 1, files / "with.csv");
  const Tuned two = run(study, 2, files / "two.csv");
  EXPECT_EQ(without_times(with.journal), without_times(two.journal));
  study.end_outdone = false;
  const Tuned without = run(study, 1, files / "without.csv");
  EXPECT_EQ(points(with), points(without));
  EXPECT_EQ(with.result.best.x, without.result.best.x);
  EXPECT_EQ(with.result.best.objective, without.result.best.objective);
  EXPECT_EQ(with.result.best.feasible, without.result.best.feasible);
  EXPECT_EQ(outdone(without), 0);
  EXPECT_GT(outdone(with), 0);
  EXPECT_LT(with.simulated, without.simulated);
  for (std::size_t i = 0; i < with.evaluations.size(); ++i) {
    const Evaluation& e = with.evaluations[i];
    const Evaluation& whole = without.evaluations[i];
    if (std::isinf(e.beyond)) {
      EXPECT_EQ(e.objective, whole.objective);
      continue;
    }
    EXPECT_FALSE(e.feasible);
    EXPECT_THAT(e.status, testing::HasSubstr("of no use to the search"));
    EXPECT_GT(penalised(whole, study.solver.penalty), e.beyond);
  }
}

INSTANTIATE_TEST_SUITE_P(Algorithms, EveryOutdone,
                         testing::Values(std::tuple(std::string("CRS2"), 90),
                                         std::tuple(std::string("ESCH"), 90)),
                         [](const auto& p) { return std::get<0>(p.param); });

TEST(Outdone, WithATermOfWhichMoreIsBetterTheSearchFindsTheSame) {
  const ShortStudy files(test::kShortParameters,
                         kObjective + "  - {metric: joint_position/min_margin, weight: 2}\n", kConstraints,
                         "search: {algorithm: CRS2, constraints: penalty, penalty: 1, max_evaluations: 80, "
                         "engine: native, verify_share: 0.05, initial_step: 0.4}\n");
  Study study = load_study(files.path());
  const Tuned with = run(study, 1, files / "with.csv");
  study.end_outdone = false;
  const Tuned without = run(study, 1, files / "without.csv");
  EXPECT_EQ(points(with), points(without));
  EXPECT_EQ(with.result.best.objective, without.result.best.objective);
  EXPECT_GT(outdone(with), 0);
  for (std::size_t i = 0; i < with.evaluations.size(); ++i) {
    if (std::isfinite(with.evaluations[i].beyond)) {
      EXPECT_GT(penalised(without.evaluations[i], study.solver.penalty), with.evaluations[i].beyond) << i;
    }
  }
}

TEST(Outdone, ARunThatGoesOnGivesUpTheSame) {
  const ShortStudy files(test::kShortParameters, kObjective, kConstraints,
                         "search: {algorithm: ESCH, constraints: penalty, penalty: 1, max_evaluations: 80, "
                         "engine: native, verify_share: 0.05}\n");
  const Study study = load_study(files.path());
  const Tuned whole = run(study, 1, files / "whole.csv");
  ASSERT_GT(outdone(whole), 0);
  std::atomic<bool> stop{false};
  const auto part = [&](Journal& journal, long most) {
    Workers workers(study.scenarios, study.stepper, 2);
    std::vector<Evaluation> evaluations;
    TuneCallbacks callbacks;
    callbacks.evaluated = [&](const char*, const Evaluation& e) {
      evaluations.push_back(e);
      if (static_cast<long>(evaluations.size()) == most) stop = true;
    };
    tune(study, workers, stop, callbacks, &journal);
    return evaluations;
  };
  const auto before = part(*Journal::begin(files / "journal.txt", {}), 70);
  EXPECT_TRUE(std::any_of(before.begin(), before.end(), [](const Evaluation& e) {
    return e.beyond < HUGE_VAL;
  })) << "one that was given up is recalled below";
  stop = false;
  std::string warning;
  const auto again = part(*Journal::resume(files / "journal.txt", {}, warning), 0);
  ASSERT_EQ(again.size(), whole.evaluations.size());
  for (std::size_t i = 0; i < again.size(); ++i) {
    EXPECT_GE(again[i].recalled, i < 70) << i;
    EXPECT_EQ(again[i].x, whole.evaluations[i].x);
    EXPECT_EQ(again[i].beyond, whole.evaluations[i].beyond);
    EXPECT_EQ(again[i].status, whole.evaluations[i].status);
  }
}

TEST(Outdone, NothingEndsWhereConstraintsAreNotPenalties) {
  const ShortStudy files(test::kShortParameters, kObjective, kConstraints,
                         "search: {algorithm: ESCH, constraints: lagrangian, max_evaluations: 60, "
                         "engine: native}\n");
  EXPECT_EQ(outdone(run(load_study(files.path()), 2, files / "evaluations.csv")), 0);
}

// An RMS is known when a rollout is over: with a second one to come there is something to save.
TEST(Outdone, NothingEndsWhereNothingIsKnownBeforeTheOnlyRolloutDoes) {
  const ShortStudy files;
  for (const std::string scenarios : {"[short.yaml]", "[short.yaml, short_realistic.yaml]"}) {
    files.write("study.yaml",
                "description: what is known at the end only\ngains: gains.yaml\nscenarios: " + scenarios +
                    "\n" + test::kShortParameters +
                    "objective: [{metric: error/orientation/rms, weight: 1}]\n" +
                    "search: {algorithm: ESCH, constraints: penalty, max_evaluations: 90, engine: native}\n");
    const Study study = load_study(files.path());
    const long given_up = outdone(run(study, 2, files / fmt::format("{}.csv", study.scenarios.size())));
    EXPECT_EQ(given_up > 0, study.scenarios.size() > 1) << given_up;
  }
}

}  // namespace
}  // namespace armtune
