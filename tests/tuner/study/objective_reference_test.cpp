// The objective is relative to the start gains: what they must give, and where rollouts end because of them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/tuner/study/two_scenarios.hpp"

namespace armtune::internal {
namespace objective_reference_test {

using test::diverged;
using test::ObjectiveOfTwoScenarios;
using test::refused_at;
using testing::HasSubstr;

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
  const InputError error = refusal();
  EXPECT_THAT(error, refused_at({.file = "study.yaml",
                                 .key = "constraints/0/hopeless",
                                 .value = "1.8",
                                 .limit = "above 1.9, or never"}));
  EXPECT_THAT(error.what(), HasSubstr("joint_velocity/max_ratio of the start gains in hard"));
  constraints_[0].hopeless.value = 1.95;
  EXPECT_FALSE(objective().end_limits()[1].empty());
}

TEST_F(ObjectiveOfTwoScenarios, AStartThatGivesNoReferenceIsRefused) {
  const auto whole = start_;
  start_[1].metrics[Metric::kOrientationMax] = NAN;
  const InputError missing = refusal();
  EXPECT_THAT(missing, refused_at({.file = "study.yaml", .key = "objective/1", .value = ""}));
  EXPECT_THAT(missing.what(), HasSubstr("error/orientation/max in hard"));
  start_[1].metrics[Metric::kOrientationMax] = 0.0;
  EXPECT_THAT(refusal(), refused_at({.key = "objective/1", .value = "0", .limit = "above zero"}));
  terms_[1].floor = 1e-3;
  EXPECT_NO_THROW(objective());
  start_ = whole;
  start_[0] = diverged(1.0);
  const InputError incomplete = refusal();
  EXPECT_THAT(incomplete, refused_at({.file = "study.yaml", .key = "gains", .value = "plain"}));
  EXPECT_THAT(incomplete.what(), HasSubstr("diverged early")) << "the reason of the rollout";
}

TEST_F(ObjectiveOfTwoScenarios, ALimitOfStartNeedsAValueOfTheStart) {
  start_[1].metrics[Metric::kObstacleMinClearance] = NAN;
  EXPECT_THAT(
      refusal(),
      refused_at(
          {.file = "study.yaml", .key = "constraints/1/at_least", .value = "start", .limit = "a number"}));
  constraints_[1].limit = 0.1;
  EXPECT_NO_THROW(objective());
}

}  // namespace objective_reference_test
}  // namespace armtune::internal
