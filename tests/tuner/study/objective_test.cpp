#include "tuner/study/objective.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/tuner/study/two_scenarios.hpp"

namespace armtune::internal {
namespace objective_test {

using test::completed;
using test::diverged;
using test::ObjectiveOfTwoScenarios;
using test::refused_at;
using testing::HasSubstr;

TEST_F(ObjectiveOfTwoScenarios, TheStartScoresExactlyOne) {
  const Evaluation e = judged(start_);
  EXPECT_EQ(e.objective, 1.0);
  EXPECT_EQ(e.violation, 0.0);
  EXPECT_TRUE(e.feasible);
  EXPECT_TRUE(e.completed);
  EXPECT_EQ(e.reason, "");
}

TEST_F(ObjectiveOfTwoScenarios, IsTheWeightedMeanOfRatiosAgainstTheStart) {
  // Position: halved and kept, mean 0.75; orientation of the second: a quarter.
  const Evaluation e = judged({completed(0.001, 0.9, 0.4, NAN), completed(0.004, 0.01, 0.8, 0.2)});
  EXPECT_DOUBLE_EQ(e.objective, (1.0 * 0.75 + 3.0 * 0.25) / 4.0);
}

TEST_F(ObjectiveOfTwoScenarios, AFloorStandsForASmallReference) {
  terms_ = {{Metric::kPositionMax, 1.0, 0.01, {0, 1}}};
  EXPECT_DOUBLE_EQ(judged(start_).objective, (0.2 + 0.4) / 2.0);
}

TEST_F(ObjectiveOfTwoScenarios, ConstraintsAreInNaturalUnitsAndTheWorstScenarioCounts) {
  const Evaluation e = judged({completed(0.002, 0.02, 0.95, NAN), completed(0.004, 0.04, 0.5, 0.15)});
  ASSERT_EQ(e.constraints.size(), 3U) << "two, and one for completing";
  EXPECT_NEAR(e.constraints[0], 0.05, 1e-15) << "0.95 where 0.9 is allowed";
  EXPECT_NEAR(e.constraints[1], 0.05, 1e-15) << "0.05 m closer than the start";
  EXPECT_EQ(e.constraints[2], 0.0);
  EXPECT_NEAR(e.violation, 0.05 / 0.9 + 0.05 / 0.2, 1e-12) << "relative to the limits";
  EXPECT_FALSE(e.feasible);
  const Evaluation inside = judged({completed(0.002, 0.02, 0.3, NAN), completed(0.004, 0.04, 0.5, 0.3)});
  EXPECT_NEAR(inside.constraints[0], -0.4, 1e-15);
  EXPECT_NEAR(inside.constraints[1], -0.1, 1e-15);
  EXPECT_EQ(inside.violation, 0.0);
  EXPECT_TRUE(inside.feasible);
}

TEST_F(ObjectiveOfTwoScenarios, ALimitOfStartIsTheStartsOwnValueInThatScenario) {
  EXPECT_EQ(objective().limit(0, 0), 0.9);
  EXPECT_EQ(objective().limit(1, 1), 0.2);
  EXPECT_TRUE(std::isnan(objective().limit(1, 0))) << "no obstacles there, nothing to judge";
  EXPECT_EQ(objective().constraint_name(0), "joint_velocity/max_ratio <= 0.9");
  EXPECT_EQ(objective().constraint_name(1), "obstacle/min_clearance >= start");
}

TEST_F(ObjectiveOfTwoScenarios, WhatDivergesIsInfeasibleAndWorseTheEarlierItEnds) {
  const double finished = judged({start_[0], completed(1e9, 1e9, 0.5, 0.3)}).objective;
  double objective = HUGE_VAL;
  double violation = HUGE_VAL;
  for (const double end : {0.01, 1.0, 5.0, 9.99}) {
    const Evaluation e = judged({start_[0], diverged(end)});
    EXPECT_FALSE(e.feasible);
    EXPECT_FALSE(e.completed);
    EXPECT_EQ(e.reason, "diverged early");
    ASSERT_TRUE(std::isfinite(e.objective));
    ASSERT_TRUE(std::isfinite(e.violation));
    for (const double g : e.constraints) EXPECT_TRUE(std::isfinite(g));
    EXPECT_LT(e.objective, objective) << end;
    EXPECT_LT(e.violation, violation) << end;
    EXPECT_GE(e.objective, finished) << "no completed rollout scores worse, however wild";
    objective = e.objective;
    violation = e.violation;
  }
}

/// Ended at `end` with this velocity ratio, every other bound kept.
RolloutResult hopeless(double end, double ratio) {
  RolloutResult r = completed(0.001, 0.01, ratio, 0.3);
  r.status = RolloutStatus::kHopeless;
  r.end_time = end;
  r.reason = "beyond repair";
  return r;
}

TEST_F(ObjectiveOfTwoScenarios, WhatIsHopelessIsWorseTheEarlierItEnded) {
  double objective = HUGE_VAL;
  double violation = HUGE_VAL;
  for (const double end : {0.0, 0.002, 1.0, 5.0, 9.998}) {
    const Evaluation e = judged({start_[0], hopeless(end, 2.0)});
    EXPECT_FALSE(e.feasible);
    EXPECT_EQ(e.reason, "beyond repair");
    EXPECT_LT(e.objective, objective) << end;
    EXPECT_LT(e.violation, violation) << end;
    EXPECT_LT(e.relative.back(), 2.0) << "no more than one that diverged at once";
    objective = e.objective;
    violation = e.violation;
  }
}

TEST_F(ObjectiveOfTwoScenarios, WhatIsHopelessIsWorseTheFartherItWentInTheSameTime) {
  double objective = 0.0;
  double violation = 0.0;
  for (const double ratio : {1.8, 1.9, 3.0, 9.0}) {
    const Evaluation e = judged({start_[0], hopeless(4.0, ratio)});
    EXPECT_GT(e.objective, objective) << ratio;
    EXPECT_GT(e.violation, violation) << ratio;
    objective = e.objective;
    violation = e.violation;
  }
  for (const double ratio : {1e9, HUGE_VAL}) {
    const Evaluation e = judged({start_[0], hopeless(4.0, ratio)});
    EXPECT_TRUE(std::isfinite(e.objective)) << ratio;
    EXPECT_TRUE(std::isfinite(e.violation)) << ratio;
    EXPECT_GE(e.objective, objective) << ratio;
  }
}

TEST_F(ObjectiveOfTwoScenarios, WhatDivergedIsNoBetterThanWhatWasHopelessByThen) {
  for (const double end : {0.5, 5.0, 9.9}) {
    RolloutResult far = hopeless(end, 1e9);
    RolloutResult gone = far;
    gone.status = RolloutStatus::kDiverged;
    EXPECT_GT(judged({start_[0], gone}).objective, judged({start_[0], far}).objective) << end;
    EXPECT_TRUE(better(judged({start_[0], far}), judged({start_[0], gone}))) << end;
  }
}

TEST_F(ObjectiveOfTwoScenarios, WhateverCompletesIsBetterThanWhatIsHopeless) {
  const Evaluation late = judged({start_[0], hopeless(9.998, 1.8)});
  for (const double clearance : {0.3, -1e9}) {
    for (const double ratio : {0.5, 1e9}) {
      const Evaluation wild =
          judged({completed(1e9, 1e9, ratio, NAN), completed(1e9, 1e9, ratio, clearance)});
      EXPECT_TRUE(better(wild, late)) << ratio << " " << clearance;
      EXPECT_FALSE(better(late, wild)) << ratio << " " << clearance;
    }
  }
  // With all other scenarios alike the objective says so too.
  EXPECT_LT(judged({start_[0], completed(1e9, 1e9, 1e9, -1e9)}).objective, late.objective);
}

TEST_F(ObjectiveOfTwoScenarios, MoreDivergedScenariosAreWorse) {
  EXPECT_GT(judged({diverged(5.0), diverged(5.0)}).violation, judged({start_[0], diverged(5.0)}).violation);
  EXPECT_GT(judged({diverged(5.0), diverged(5.0)}).objective, judged({start_[0], diverged(5.0)}).objective);
}

TEST_F(ObjectiveOfTwoScenarios, TheFirstFailureGivesTheReasonWhateverItsWords) {
  RolloutResult first = diverged(5.0);
  first.reason = "completed";
  for (const auto& results : {std::vector{first, diverged(5.0)}, std::vector{start_[0], first}}) {
    const Evaluation e = judged(results);
    EXPECT_FALSE(e.completed);
    EXPECT_EQ(e.reason, "completed");
  }
}

TEST_F(ObjectiveOfTwoScenarios, WithoutSamplesACandidateIsInfeasibleWithFiniteScores) {
  RolloutResult blank = completed(NAN, NAN, 0.5, 0.3);
  blank.status = RolloutStatus::kNoSamples;
  blank.reason = "no period counted";
  const Evaluation e = judged({start_[0], blank});
  EXPECT_FALSE(e.feasible);
  EXPECT_TRUE(std::isfinite(e.objective));
  EXPECT_GT(e.objective, 1.0);
  EXPECT_FALSE(e.completed);
  EXPECT_EQ(e.reason, "no period counted");
}

TEST_F(ObjectiveOfTwoScenarios, ABetterValueOfAnyMetricIsABetterCandidate) {
  constraints_.clear();
  for (const Metric m : all_metrics()) {
    const Better direction = field(m).better;
    if (direction == Better::kNeither) continue;
    terms_ = {{m, 1.0, 0.0, {0}}, {Metric::kPositionMax, 2.0, 0.0, {1}}};
    for (RolloutResult& r : start_) r.metrics[m] = 0.4;
    const auto with = [&](double value) {
      std::vector<RolloutResult> results = start_;
      results[0].metrics[m] = value;
      return judged(results);
    };
    EXPECT_EQ(with(0.4).objective, 1.0) << name(m);
    const auto [good, bad] = direction == Better::kMore ? std::pair(0.6, 0.2) : std::pair(0.2, 0.6);
    EXPECT_TRUE(better(with(good), with(0.4))) << name(m);
    EXPECT_TRUE(better(with(0.4), with(bad))) << name(m);
  }
}

TEST_F(ObjectiveOfTwoScenarios, AMarginThatIsPassedAtTheStartNeedsAFloorAndThenHasASlope) {
  terms_ = {{Metric::kObstacleMinClearance, 1.0, 0.0, {1}}};
  constraints_.clear();
  for (const double start : {0.0, -0.05}) {
    start_[1].metrics[Metric::kObstacleMinClearance] = start;
    const InputError error = refusal();
    EXPECT_THAT(error, refused_at({.file = "study.yaml",
                                   .key = "objective/0",
                                   .value = fmt::format("{}", start),
                                   .limit = "above zero"}));
    EXPECT_THAT(error.what(), HasSubstr("'floor'"));
    EXPECT_THAT(error.what(), HasSubstr("'at_least' needs no reference"));
  }
  terms_[0].floor = 0.1;
  double last = HUGE_VAL;
  for (const double clearance : {-0.3, -0.05, 0.0, 0.01, 0.05, 0.1, 0.2}) {
    const double objective = judged({start_[0], completed(0.004, 0.04, 0.8, clearance)}).objective;
    EXPECT_LT(objective, last) << clearance;
    last = objective;
    if (clearance == 0.1) {
      EXPECT_EQ(objective, 1.0) << "the floor is the reference";
    }
  }
}

TEST_F(ObjectiveOfTwoScenarios, ABoundOnWhatAScenarioDoesNotHaveHoldsThere) {
  constraints_[1].limit = 0.1;  // clearance; the first scenario has no obstacles
  const Evaluation e = judged(start_);
  EXPECT_TRUE(e.feasible) << e.violation;
}

TEST_F(ObjectiveOfTwoScenarios, AWildViolationCountsNoMoreThanTenfold) {
  const Evaluation e = judged({completed(0.002, 0.02, 1e9, NAN), completed(0.004, 0.04, 0.8, 0.2)});
  EXPECT_FALSE(e.feasible);
  EXPECT_DOUBLE_EQ(e.violation, 10.0);
  EXPECT_DOUBLE_EQ(e.constraints[0], 1e9 - 0.9) << "the value itself is reported as it is";
}

TEST_F(ObjectiveOfTwoScenarios, DivergingScoresWorseThanAnyCompletedRollout) {
  const Evaluation wild = judged({completed(1e9, 1e9, 0.4, NAN), completed(1e9, 1e9, 0.8, 0.2)});
  const Evaluation late = judged({diverged(9.999), diverged(9.999)});
  EXPECT_GT(late.objective, wild.objective);
}

}  // namespace objective_test
}  // namespace armtune::internal
