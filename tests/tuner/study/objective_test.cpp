#include "tuner/study/objective.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace objective_test {

using testing::HasSubstr;

/// A completed rollout with these values in every metric that the tests look at.
RolloutResult completed(double position, double orientation, double ratio, double clearance) {
  RolloutResult r;
  r.end_time = 10.0;
  r.metrics[Metric::kPositionMax] = position;
  r.metrics[Metric::kOrientationMax] = orientation;
  r.metrics[Metric::kJointVelocityMaxRatio] = ratio;
  r.metrics[Metric::kObstacleMinClearance] = clearance;
  return r;
}

RolloutResult diverged(double end_time) {
  RolloutResult r;
  r.status = RolloutStatus::kDiverged;
  r.end_time = end_time;
  r.reason = "diverged early";
  return r;
}

/// Two scenarios of 10 s: positions weigh 1 in both, orientation weighs 3 in the second.
class ObjectiveOfTwoScenarios : public testing::Test {
 protected:
  ObjectiveOfTwoScenarios() {
    scenarios_.resize(2);
    scenarios_[0].name = "plain";
    scenarios_[1].name = "hard";
    for (Scenario& s : scenarios_) s.duration = 10.0;
    scenarios_[1].obstacles.resize(1);  // there clearance is judged
  }

  Objective objective() const { return {terms_, constraints_, scenarios_, start_, "study.yaml"}; }
  Evaluation judged(std::vector<RolloutResult> results) const {
    Evaluation e;
    e.results = std::move(results);
    objective().judge(e);
    return e;
  }

  std::vector<Scenario> scenarios_;
  std::vector<RolloutResult> start_ = {completed(0.002, 0.02, 0.4, NAN), completed(0.004, 0.04, 0.8, 0.2)};
  std::vector<ObjectiveTerm> terms_ = {{Metric::kPositionMax, 1.0, 0.0, {0, 1}},
                                       {Metric::kOrientationMax, 3.0, 0.0, {1}}};
  std::vector<Constraint> constraints_ = {{Metric::kJointVelocityMaxRatio, true, 0.9, {0, 1}},
                                          {Metric::kObstacleMinClearance, false, {}, {0, 1}}};
};

TEST_F(ObjectiveOfTwoScenarios, TheStartScoresExactlyOne) {
  const Evaluation e = judged(start_);
  EXPECT_EQ(e.objective, 1.0);
  EXPECT_EQ(e.violation, 0.0);
  EXPECT_TRUE(e.feasible);
  EXPECT_EQ(e.status, "completed");
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
    EXPECT_EQ(e.status, "diverged early");
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
    EXPECT_EQ(e.status, "beyond repair");
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

TEST_F(ObjectiveOfTwoScenarios, EndsRolloutsAtTwiceTheVelocityLimitWhereItIsJudged) {
  constraints_[0].scenarios = {1};
  const Objective o = objective();
  ASSERT_EQ(o.end_limits().size(), 2U);
  EXPECT_TRUE(o.end_limits()[0].empty()) << "the constraint does not list it";
  ASSERT_EQ(o.end_limits()[1].size(), 1U) << "clearance is never hopeless by default";
  EXPECT_EQ(o.end_limits()[1][0].metric, Metric::kJointVelocityMaxRatio);
  EXPECT_DOUBLE_EQ(o.end_limits()[1][0].value, 1.8);
  constraints_[0].hopeless.kind = Hopeless::Kind::kNever;
  EXPECT_TRUE(objective().end_limits()[1].empty());
}

TEST_F(ObjectiveOfTwoScenarios, EndsRolloutsAtTwiceTheStartsValueWhereThatIsTheLimit) {
  constraints_[0].limit.reset();
  EXPECT_DOUBLE_EQ(objective().end_limits()[0].at(0).value, 2.0 * 0.4);
  EXPECT_DOUBLE_EQ(objective().end_limits()[1].at(0).value, 2.0 * 0.8);
}

TEST_F(ObjectiveOfTwoScenarios, AStatedEndHoldsOnlyWhereTheMetricApplies) {
  constraints_[1].hopeless = {Hopeless::Kind::kFrom, 0.05};
  EXPECT_EQ(objective().end_limits()[0].size(), 1U) << "no obstacles there";
  ASSERT_EQ(objective().end_limits()[1].size(), 2U);
  const EndLimit end = objective().end_limits()[1][1];
  EXPECT_TRUE(end.reached_by(0.05));
  EXPECT_FALSE(end.reached_by(0.051)) << "of clearance more is better";
  EXPECT_FALSE(end.reached_by(NAN));
}

TEST_F(ObjectiveOfTwoScenarios, TheStartIsNeverHopeless) {
  start_[1].metrics[Metric::kJointVelocityMaxRatio] = 1.9;
  EXPECT_FALSE(objective().end_limits()[0].empty());
  EXPECT_TRUE(objective().end_limits()[1].empty()) << "where the start passes the default there is none";
  constraints_[0].hopeless = {Hopeless::Kind::kFrom, 1.8};
  EXPECT_THAT(test::refusal([&] { objective(); }),
              testing::AllOf(testing::StartsWith("study.yaml"), HasSubstr("joint_velocity/max_ratio"),
                             HasSubstr("hard"), HasSubstr("1.9"), HasSubstr("1.8"), HasSubstr("never")));
  constraints_[0].hopeless.value = 1.95;
  EXPECT_FALSE(objective().end_limits()[1].empty());
}

TEST_F(ObjectiveOfTwoScenarios, MoreDivergedScenariosAreWorse) {
  EXPECT_GT(judged({diverged(5.0), diverged(5.0)}).violation, judged({start_[0], diverged(5.0)}).violation);
  EXPECT_GT(judged({diverged(5.0), diverged(5.0)}).objective, judged({start_[0], diverged(5.0)}).objective);
}

TEST_F(ObjectiveOfTwoScenarios, WithoutSamplesACandidateIsInfeasibleWithFiniteScores) {
  RolloutResult blank = completed(NAN, NAN, 0.5, 0.3);
  blank.status = RolloutStatus::kNoSamples;
  blank.reason = "no period counted";
  const Evaluation e = judged({start_[0], blank});
  EXPECT_FALSE(e.feasible);
  EXPECT_TRUE(std::isfinite(e.objective));
  EXPECT_GT(e.objective, 1.0);
  EXPECT_EQ(e.status, "no period counted");
}

TEST_F(ObjectiveOfTwoScenarios, AStartThatGivesNoReferenceIsRefused) {
  const auto message = [&] { return test::refusal([&] { objective(); }); };
  const auto whole = start_;
  start_[1].metrics[Metric::kOrientationMax] = NAN;
  EXPECT_THAT(message(), testing::AllOf(testing::StartsWith("study.yaml"), HasSubstr("error/orientation/max"),
                                        HasSubstr("hard"), HasSubstr("floor")));
  start_[1].metrics[Metric::kOrientationMax] = 0.0;
  EXPECT_THAT(message(), testing::AllOf(HasSubstr("error/orientation/max"), HasSubstr("reference")));
  terms_[1].floor = 1e-3;
  EXPECT_NO_THROW(objective());
  start_ = whole;
  start_[0] = diverged(1.0);
  EXPECT_THAT(message(), testing::AllOf(HasSubstr("plain"), HasSubstr("diverged early")));
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
    EXPECT_THAT(test::refusal([&] { objective(); }),
                testing::AllOf(testing::StartsWith("study.yaml"), HasSubstr("obstacle/min_clearance"),
                               HasSubstr("hard"), HasSubstr(fmt::format("{}", start)), HasSubstr("floor"),
                               HasSubstr("at_least")));
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
