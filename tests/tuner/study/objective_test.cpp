#include "tuner/study/objective.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/support/files.hpp"

namespace armtune {
namespace {

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
  EXPECT_THAT(message(), HasSubstr("no reference"));
  terms_[1].floor = 1e-3;
  EXPECT_NO_THROW(objective());
  start_ = whole;
  start_[0] = diverged(1.0);
  EXPECT_THAT(message(), testing::AllOf(HasSubstr("plain"), HasSubstr("diverged early")));
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

}  // namespace
}  // namespace armtune
