#include "tuner/first_task/first_gain_sets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/control/laws/starting_gains.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/default_task.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace first_gain_sets_test {

TEST(FirstGainSets, BeginWithTheGivenOneAndDifferInFourGains) {
  const Scenario scenario = test::scenario_of("moving_target");
  const Gains start = test::quick_gains(scenario);
  const std::vector<Gains> sets = first_gain_sets(*scenario.robot, scenario.start_position, start);
  EXPECT_EQ(gains_yaml(sets.front(), {}), gains_yaml(start, {}));
  bool firmer = false, softer = false, slower = false, still = false;
  for (const Gains& gains : sets) {
    firmer = firmer || gains.task_space_gains_d[0] > start.task_space_gains_d[0];
    softer = softer || (gains.task_space_gains_d[0] < start.task_space_gains_d[0] &&
                        gains.task_space_gains_p[0] < start.task_space_gains_p[0]);
    slower = slower || (gains.slerpDurationErrorGain > start.slerpDurationErrorGain &&
                        gains.trajectoryDurationErrorGain > start.trajectoryDurationErrorGain);
    still = still || gains.adaptation_gain == 0.0;
    EXPECT_LE(gains.task_space_gains_p[0], start.task_space_gains_p[0]);
    EXPECT_GE(gains.slerpDurationErrorGain, start.slerpDurationErrorGain);
  }
  EXPECT_TRUE(firmer && softer && slower && still);
}

/// A heavy arm of five joints. Two of them slide, the last by 0.16 m only.
struct Heavy {
  std::shared_ptr<const RobotModel> arm = std::make_shared<const RobotModel>(test::random_arm(5, 1033, true));
  DefaultTask task;
  Gains start;

  Heavy() {
    TaskOptions options;
    options.thorough = true;
    task = default_task(arm, options);
    start = starting_gains(*arm, task.scenario.start_position, task.goal, task.manipulability);
  }
};

/// How far the arm is from `goal` at last when it is held there with a fifth of its weight unknown, as shares
/// of the joints' ranges; 0 for joints without limits.
JointVector gives_way(const Heavy& heavy, Gains gains) {
  Scenario scenario = heavy.task.scenario;
  scenario.plant = {};
  scenario.duration = 20.0;
  scenario.start_position = heavy.task.goal;
  gains.joint_goal_follows_task = false;
  gains.joint_trajectory_duration = scenario.duration;
  gains.adaptation_gain = 0.0;
  JointVector q;
  Rollout(scenario, Stepper::kMidpoint, Engine::kNative).run(gains, [&](const Observation& seen) {
    q = *seen.q;
    return true;
  });
  JointVector shares = JointVector::Zero(heavy.arm->n());
  for (int i = 0; i < heavy.arm->n(); ++i) {
    const JointLimits& limits = heavy.arm->joints[static_cast<std::size_t>(i)].limits;
    if (limits.has_position) shares[i] = std::abs(q[i] - heavy.task.goal[i]) / (limits.upper - limits.lower);
  }
  return shares;
}

// Kd Kp e balances the weight that the model lacks: at rest, and with the torques of the place where it
// rests.
TEST(HoldingFirmness, KeepsUnknownWeightFromMovingJointsByMoreThanAFiftiethOfTheirRange) {
  const Heavy heavy;
  const JointVector firmness = holding_firmness(*heavy.arm, heavy.task.goal, heavy.start);
  Gains firm = heavy.start;
  firm.joint_space_gains_d.array() *= firmness.array();
  const JointVector before = gives_way(heavy, heavy.start);
  const JointVector after = gives_way(heavy, firm);
  bool some = false;
  for (int i = 0; i < heavy.arm->n(); ++i) {
    EXPECT_GE(firmness[i], 1.0);
    EXPECT_LE(after[i], 1.2 * 0.02) << i;
    if (firmness[i] == 1.0 || firmness[i] == 6.0) continue;
    some = true;
    // Firmer by as much as the joint gave way too far.
    EXPECT_NEAR(before[i] / 0.02, firmness[i], 0.25 * firmness[i]) << i;
    EXPECT_NEAR(after[i], 0.02, 0.2 * 0.02) << i;
  }
  EXPECT_TRUE(some);
}

TEST(HoldingFirmness, IsOneForAnArmThatGivesWayLittleAndForJointsWithoutLimits) {
  const Heavy heavy;
  RobotModel free = *heavy.arm;
  for (JointInfo& joint : free.joints) joint.limits.has_position = false;
  EXPECT_EQ(holding_firmness(free, heavy.task.goal, heavy.start), JointVector::Ones(free.n()));
  Gains firm = heavy.start;
  firm.joint_space_gains_p *= 1e6;
  EXPECT_EQ(holding_firmness(*heavy.arm, heavy.task.goal, firm), JointVector::Ones(free.n()));
}

}  // namespace first_gain_sets_test
}  // namespace armtune::internal
