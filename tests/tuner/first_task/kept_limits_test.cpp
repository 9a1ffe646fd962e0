#include "tuner/first_task/kept_limits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/control/laws/starting_gains.hpp"
#include "sim/plant/flush_denormals.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/default_task.hpp"
#include "sim/scenario/robot_file.hpp"

namespace armtune::internal {
namespace kept_limits_test {

RolloutResult with(Metric metric, double value) {
  RolloutResult result;
  result.metrics[Metric::kJointVelocityMaxRatio] = 0.5;
  result.metrics[Metric::kJointEffortMaxRatio] = 0.5;
  result.metrics[metric] = value;
  return result;
}

TEST(KeptLimits, ALimitIsLostJustBeyondItsShare) {
  const Scenario scenario = default_task(load_robot("ur10")).scenario;
  const FlushDenormals as_in_rollouts;
  for (const EndLimit& end : ends_of_kept_limits(scenario, 0.9)) {
    const double last = larger_is_better(end.metric) ? 0.0 : 0.9;
    EXPECT_TRUE(keeps_limits(with(end.metric, last), 0.9)) << name(end.metric);
    EXPECT_FALSE(end.reached_by(last)) << name(end.metric);
    EXPECT_FALSE(keeps_limits(with(end.metric, end.value), 0.9)) << name(end.metric);
    EXPECT_TRUE(end.reached_by(end.value)) << name(end.metric);
  }
  EXPECT_FALSE(keeps_limits(with(Metric::kJointVelocityMaxRatio, std::nan("")), 0.9)) << "never measured";
}

// A rollout that ends early must have lost what a whole one loses.
TEST(KeptLimits, AnEarlyEndIsTheFateOfTheWholeRollout) {
  int lost = 0, kept = 0;
  for (const char* robot : {"ur5e", "youbot"}) {
    const DefaultTask task = default_task(load_robot(robot));
    Rollout rollout(task.scenario, Stepper::kMidpoint, Engine::kNative);
    const Gains start =
        starting_gains(*task.scenario.robot, task.scenario.start_position, task.goal, task.manipulability);
    for (const double factor : {0.1, 0.5, 1.0, 2.0, 8.0}) {
      Gains gains = start;
      gains.task_space_gains_d *= factor;
      gains.joint_space_gains_d *= factor;
      const bool whole = keeps_limits(rollout.run(gains), 0.5);
      const RolloutResult early = rollout.run(gains, {}, ends_of_kept_limits(task.scenario, 0.5));
      EXPECT_EQ(keeps_limits(early, 0.5), whole) << robot << ", Kd times " << factor;
      (whole ? kept : lost) += 1;
    }
  }
  EXPECT_GT(lost, 0);
  EXPECT_GT(kept, 0);
}

TEST(KeptLimits, WhatIsLostIsNamed) {
  EXPECT_THAT(lost_limits(with(Metric::kJointEffortMaxRatio, 0.95), 0.9),
              testing::HasSubstr("0.9 of the joint's effort limit"));
  EXPECT_THAT(lost_limits(with(Metric::kJointVelocityMaxRatio, 0.95), 0.9),
              testing::HasSubstr("exceeds 0.9 of its limit"));
  EXPECT_THAT(lost_limits(with(Metric::kJointPositionMinMargin, -0.1), 0.9),
              testing::HasSubstr("position limits"));
  EXPECT_THAT(lost_limits(with(Metric::kJointAccelerationMaxRatio, 0.95), 0.9),
              testing::HasSubstr("the acceleration of a joint exceeds 0.9"));
  EXPECT_FALSE(keeps_limits(with(Metric::kJointAccelerationMaxRatio, 0.95), 0.9));
  EXPECT_THAT(lost_limits(with(Metric::kClearanceFloor, -0.1), 0.9), testing::HasSubstr("the floor"));
}

}  // namespace kept_limits_test
}  // namespace armtune::internal
