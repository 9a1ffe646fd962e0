// No allocation inside a control period: sensors, controller, metrics, native plant. Simbody's own work is
// its own affair.

#include <gtest/gtest.h>

#include "tests/core/support/allocation_counter.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune {
namespace {

class RolloutAllocation : public testing::TestWithParam<std::string> {};

TEST_P(RolloutAllocation, NeverHappensInAPeriodOfTheNativeEngine) {
  if (!test::allocations_are_counted()) GTEST_SKIP() << "a sanitizer owns malloc";
  const Scenario scenario = test::scenario_of(GetParam());
  const Gains gains = test::published_gains(scenario);
  for (const Stepper stepper : {Stepper::kMidpoint, Stepper::kRungeKutta4}) {
    Rollout rollout(scenario, stepper, Engine::kNative);
    long first = -1;
    long last = -1;
    int periods = 0;
    rollout.run(gains, [&](const Observation&) {
      if (first < 0) first = test::allocations();
      last = test::allocations();
      ++periods;
      return true;
    });
    EXPECT_EQ(periods, scenario.periods());
    EXPECT_EQ(last, first) << name(stepper);
  }
}

INSTANTIATE_TEST_SUITE_P(Bundled, RolloutAllocation,
                         testing::Values("moving_target", "realistic_target_switch",
                                         "realistic_obstacle_pass", "realistic_camera_target"),
                         [](const auto& scenario) { return scenario.param; });

}  // namespace
}  // namespace armtune
