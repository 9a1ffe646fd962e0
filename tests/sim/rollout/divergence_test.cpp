#include "sim/rollout/divergence.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/first_gains.hpp"
#include "sim/lanes/rollout_lanes.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace divergence_test {

using test::quick_gains;
using test::scenario_of;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// |v| after 3000 periods of v <- v - a v(d periods ago), from 1.
double after_damping(double a, int d) {
  std::vector<double> v(static_cast<std::size_t>(d) + 1, 1.0);
  double largest = 0.0;
  for (int k = 0; k < 3000; ++k) {
    v.push_back(v.back() - a * v[v.size() - 1 - static_cast<std::size_t>(d)]);
    if (k >= 2900) largest = std::max(largest, std::abs(v.back()));
  }
  return largest;
}

TEST(Divergence, TheLimitOfALateDampingIsWhereItsVelocityNoLongerDecays) {
  for (int d = 0; d <= 5; ++d) {
    EXPECT_LT(after_damping(0.97 * damping_limit(d), d), 0.1) << d;
    EXPECT_GT(after_damping(1.03 * damping_limit(d), d), 10.0) << d;
  }
}

/// moving_target with an arm whose last joint turns what its link weighs alone.
Scenario light_last_joint() {
  Scenario scenario = scenario_of("moving_target", 5.0);
  auto robot = std::make_shared<RobotModel>(*scenario.robot);
  robot->chain.rotor_inertia[5] = 0.0;
  scenario.robot = robot;
  return scenario;
}

TEST(Divergence, DampingIsUnstableFromItsLimitOnOfTheInertiaThatTheJointMoves) {
  const Scenario scenario = light_last_joint();
  const JointState measured{scenario.start_position, JointVector::Zero(6)};
  for (const int delay : {0, 1, 3}) {
    for (const double friction : {0.0, 0.7}) {
      Scenario changed = scenario;
      changed.plant.torque_delay_periods = delay;
      changed.plant.viscous_friction = JointVector::Constant(6, friction);
      const PreparedScenario prepared(changed);
      const double h = changed.control_period;
      const JointVector c = prepared.plant.chain.viscous_friction;
      const JointVector inertia = joint_inertia(prepared.plant, measured.q);
      // Where the damping beyond friction takes away the limit's share of the velocity.
      const JointVector limit = damping_limit(delay) * (inertia / h + c) + c;
      EXPECT_THAT(unstable_damping(prepared, measured, 0.99 * limit), IsEmpty());
      for (int i = 0; i < 6; ++i) {
        JointVector Kd = 0.5 * limit;
        Kd[i] = 1.01 * limit[i];
        const std::string cause = unstable_damping(prepared, measured, Kd);
        EXPECT_THAT(cause, HasSubstr(scenario.robot->joints[static_cast<std::size_t>(i)].name));
        EXPECT_THAT(cause, HasSubstr(fmt::format(" {:.3g} * ", Kd[i])));
        EXPECT_THAT(cause, HasSubstr(fmt::format("{:.3g}", inertia[i])));
      }
    }
  }
}

TEST(Divergence, NothingIsSaidOfNumbersThatAreNotFinite) {
  const PreparedScenario prepared(light_last_joint());
  const JointVector finite = JointVector::Constant(6, 1e6);
  const JointVector broken = JointVector::Constant(6, std::nan(""));
  EXPECT_THAT(unstable_damping(prepared, {broken, JointVector::Zero(6)}, finite), IsEmpty());
  EXPECT_THAT(unstable_damping(prepared, {JointVector::Zero(6), broken}, finite), IsEmpty());
  EXPECT_THAT(unstable_damping(prepared, {JointVector::Zero(6), JointVector::Zero(6)}, broken), IsEmpty());
}

TEST(Divergence, ARolloutThatDampsALightJointTooMuchNamesTheJointAndTheCause) {
  const Scenario scenario = light_last_joint();
  const Gains gains = quick_gains(scenario);
  const std::string joint = scenario.robot->joints[5].name;
  for (const Engine engine : kEngines) {
    const RolloutResult result = Rollout(scenario, Stepper::kMidpoint, engine).run(gains);
    ASSERT_EQ(result.status, RolloutStatus::kDiverged);
    EXPECT_THAT(result.reason, HasSubstr("the damping of " + joint));
    EXPECT_THAT(result.reason, HasSubstr("rotor_inertia"));
  }
  // The same arm with a rotor on that joint, as the message says.
  Scenario heavier = scenario;
  heavier.robot = scenario_of("moving_target").robot;
  EXPECT_NE(Rollout(heavier, Stepper::kMidpoint).run(gains).status, RolloutStatus::kDiverged);
}

TEST(Divergence, InLanesTheReasonIsThatOfTheArmAlone) {
  const auto prepared = std::make_shared<const PreparedScenario>(light_last_joint());
  const Gains gains = quick_gains(prepared->scenario);
  const std::string alone = Rollout(prepared, Stepper::kMidpoint, Engine::kNative).run(gains).reason;
  EXPECT_THAT(alone, HasSubstr("the damping of"));
  RolloutLanes lanes(lane_kind(prepared->scenario, Stepper::kMidpoint, prepared->scenario.obstacles.size()),
                     2);
  lanes.start(0, {prepared, gains});
  while (lanes.busy() > 0) {
    lanes.step([&](int, RolloutResult&& result) { EXPECT_EQ(result.reason, alone); });
  }
}

TEST(Divergence, OtherCausesAreNotBlamedOnTheDamping) {
  const Scenario scenario = scenario_of("moving_target", 15.0);
  Gains gains = test::published_gains(scenario);
  gains.joint_space_gains_p *= 100.0;
  const RolloutResult result = Rollout(scenario, Stepper::kMidpoint).run(gains);
  ASSERT_EQ(result.status, RolloutStatus::kDiverged);
  EXPECT_THAT(result.reason, Not(HasSubstr("damping")));
}

TEST(Divergence, NoDampingIsBlamedOfALawWithoutKd) {
  const Scenario scenario = light_last_joint();
  for (const ControllerKind* kind : controller_kinds()) {
    Gains gains = quick_gains(scenario);
    change_controller(gains, kind->name, 6);
    const Controller controller(scenario.robot, gains, ParameterVector::Zero(78), scenario.control_period);
    EXPECT_EQ(controller.Kd() != nullptr, kind->name == "adaptive") << kind->name;
  }
}

}  // namespace divergence_test
}  // namespace armtune::internal
