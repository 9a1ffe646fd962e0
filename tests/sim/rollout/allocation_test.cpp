// No allocation inside a control period: sensors, controller, metrics and their series, native plant.
// Simbody's own work is its own affair.

#include <gtest/gtest.h>

#include <array>

#include "sim/lanes/rollout_lanes.hpp"
#include "tests/core/support/allocation_counter.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace allocation_test {

/// Two bundled gain sets of the scenario's arm.
std::array<const char*, 2> sets_of(const Scenario& scenario) {
  if (scenario.robot->n() == 7) return {"panda", "panda_tuned"};
  if (scenario.robot->n() == 5) return {"youbot", "youbot_tuned"};
  return {"published", "extended"};
}

class RolloutAllocation : public testing::TestWithParam<std::string> {};

TEST_P(RolloutAllocation, NeverHappensInAPeriodOfTheNativeEngine) {
  if (!test::allocations_are_counted()) GTEST_SKIP() << "a sanitizer owns malloc";
  const Scenario scenario = test::scenario_of(GetParam());
  for (const char* set : sets_of(scenario)) {
    const Gains gains = load_gains(set, joint_names(*scenario.robot));
    for (const Stepper stepper : {Stepper::kMidpoint, Stepper::kRungeKutta4}) {
      Rollout rollout(scenario, stepper, Engine::kNative);
      long first = -1;
      long last = -1;
      int periods = 0;
      const auto count = [&](const Observation&) {
        if (first < 0) first = test::allocations();
        last = test::allocations();
        ++periods;
        return true;
      };
      rollout.run(gains, count, {}, all_metrics());
      EXPECT_EQ(periods, scenario.periods());
      EXPECT_EQ(last, first) << set << ", " << name(stepper);
    }
  }
}

TEST_P(RolloutAllocation, NeverHappensInAPeriodOfArmsSideBySide) {
  if (!test::allocations_are_counted()) GTEST_SKIP() << "a sanitizer owns malloc";
  const auto prepared = std::make_shared<const PreparedScenario>(test::scenario_of(GetParam()));
  const Scenario& scenario = prepared->scenario;
  RolloutLanes lanes(lane_kind(scenario, Stepper::kMidpoint, scenario.obstacles.size()), 2);
  const auto sets = sets_of(scenario);
  lanes.start(0, {prepared, load_gains(sets[0], joint_names(*scenario.robot)), {}, all_metrics()});
  lanes.start(1, {prepared, load_gains(sets[1], joint_names(*scenario.robot))});
  const RolloutLanes::Finished finished = [](int, RolloutResult&&) {};
  lanes.step(finished);
  const long first = test::allocations();
  for (int k = 2; k < scenario.periods(); ++k) lanes.step(finished);
  EXPECT_EQ(test::allocations(), first);
  EXPECT_EQ(lanes.busy(), 2);
}

INSTANTIATE_TEST_SUITE_P(Bundled, RolloutAllocation,
                         testing::Values("moving_target", "realistic_target_switch",
                                         "realistic_obstacle_pass", "realistic_camera_target",
                                         "panda_target_switch", "youbot_target_switch"),
                         [](const auto& scenario) { return scenario.param; });

}  // namespace allocation_test
}  // namespace armtune::internal
