#include "tuner/verdict/yield_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace yield_check_test {

using testing::HasSubstr;

TEST(YieldCheck, NamesTheJointOnlyIfArmsFailMostOftenByItsVelocity) {
  const std::vector<Scenario> scenarios = {test::scenario_of("moving_target")};
  const auto checked = [&](const RolloutFailure& failure) {
    std::vector<MonteCarloSample> samples(4);
    for (MonteCarloSample& sample : samples) {
      sample.results.resize(1);
      sample.results[0].metrics.max_ratio_joint = "elbow_joint";
      sample.broken.resize(1);
    }
    samples[1].broken[0] = samples[2].broken[0] = failure;
    samples[3].broken[0] = {"another reason", {}};
    return yield_check(scenarios, samples, 0.5);
  };
  const Check velocity = checked({"too fast", Metric::kJointVelocityMaxRatio});
  EXPECT_FALSE(velocity.passed);
  EXPECT_EQ(velocity.value, 0.25);
  EXPECT_EQ(velocity.scenario, scenarios[0].name);
  EXPECT_EQ(velocity.joint, "elbow_joint");
  EXPECT_THAT(velocity.detail, HasSubstr("too fast"));
  EXPECT_EQ(checked({"too near", Metric::kJointPositionMinMargin}).joint, "");
  EXPECT_EQ(checked({"joint_velocity/max_ratio in the text alone", {}}).joint, "");
}

}  // namespace yield_check_test
}  // namespace armtune::internal
