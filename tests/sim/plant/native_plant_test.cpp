// The native plant against Simbody: two independent implementations of the same arm.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "armtune/error.hpp"
#include "sim/plant/plant.hpp"
#include "sim/scenario/data_files.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace native_plant_test {

using test::WorstError;

TEST(NativePlant, AcceleratesAsSimbodyDoes) {
  std::mt19937 generator(901);
  WorstError worst("q''", 1e-9);
  for (const RobotModel& arm : test::all_arms()) {
    const auto simbody = make_simbody_plant(arm, Stepper::kMidpoint);
    const auto native = make_native_plant(arm, Stepper::kMidpoint);
    for (int sample = 0; sample < 50; ++sample) {
      const JointVector q = test::random_configuration(generator, arm);
      const JointVector qd = test::random_vector(generator, arm.n(), 2.0);
      const JointVector torque = test::random_vector(generator, arm.n(), 100.0);
      JointVector ours;
      JointVector theirs;
      native->accelerations(q, qd, torque, ours);
      simbody->accelerations(q, qd, torque, theirs);
      worst.compare(ours, theirs, arm.name);
    }
  }
}

TEST(NativePlant, StepsAsSimbodyDoesWithEveryStepper) {
  const RobotModel arm = test::seven_joint_arm();
  std::mt19937 generator(902);
  const JointVector q = test::random_configuration(generator, arm);
  const JointVector qd = test::random_vector(generator, arm.n(), 1.0);
  const JointVector torque = test::random_vector(generator, arm.n(), 20.0);
  for (const Stepper stepper : {Stepper::kMidpoint, Stepper::kSemiImplicitEuler, Stepper::kRungeKutta4}) {
    const auto simbody = make_plant(arm, stepper, Engine::kSimbody);
    const auto native = make_plant(arm, stepper, Engine::kNative);
    for (Plant* plant : {simbody.get(), native.get()}) {
      plant->set_state(q, qd);
      for (int k = 0; k < 100; ++k) plant->step(torque, 0.002);
    }
    EXPECT_LT((native->q() - simbody->q()).norm(), 1e-11) << name(stepper);
    EXPECT_LT((native->qd() - simbody->qd()).norm(), 1e-9) << name(stepper);
    EXPECT_GT((native->q() - q).norm(), 0.1) << "it moved";
  }
}

TEST(NativePlant, HasNoReferenceStepper) {
  const std::string message = test::refusal([] { make_native_plant(test::ur10(), Stepper::kReference); });
  EXPECT_NE(message.find("engine simbody"), std::string::npos) << message;
}

/// Rounding of 20,000 steps, which a stable closed loop forgets: a thousand times what is seen, and far below
/// what any error of the dynamics would make.
constexpr double kRounding = 1e-11;

/// Rollouts with RK4 in both engines, over the whole of a bundled scenario.
class NativeRollout : public testing::TestWithParam<std::string> {};

TEST_P(NativeRollout, EndsWhereSimbodysDoes) {
  const Scenario scenario = load_scenario(GetParam());
  const std::string robot = scenario.robot->name;
  const Gains gains = load_gains(robot == "ur10" ? "published" : robot, joint_names(*scenario.robot));
  const auto ours = test::joint_path(scenario, gains, Stepper::kRungeKutta4, Engine::kNative);
  const auto theirs = test::joint_path(scenario, gains, Stepper::kRungeKutta4, Engine::kSimbody);
  ASSERT_EQ(ours.size(), static_cast<std::size_t>(scenario.periods()));
  const double difference = test::largest_difference(ours, theirs);
  RecordProperty("largest difference [rad]", fmt::format("{:.2g}", difference));
  EXPECT_LT(difference, kRounding);
  EXPECT_GT(difference, 0.0) << "two engines round differently";
}

std::vector<std::string> bundled_scenarios() {
  return bundled_names("scenarios");
}

INSTANTIATE_TEST_SUITE_P(Bundled, NativeRollout, testing::ValuesIn(bundled_scenarios()),
                         [](const auto& scenario) { return scenario.param; });

TEST(NativePlant, FollowsTheExtendedLawWithTheDefaultStepperToo) {
  for (const char* name : {"realistic_target_switch", "realistic_obstacle_pass"}) {
    const Scenario scenario = load_scenario(name);
    const Gains gains = load_gains("extended_tuned", joint_names(*scenario.robot));
    const auto ours = test::joint_path(scenario, gains, Stepper::kMidpoint, Engine::kNative);
    const auto theirs = test::joint_path(scenario, gains, Stepper::kMidpoint, Engine::kSimbody);
    ASSERT_EQ(ours.size(), theirs.size());
    EXPECT_LT(test::largest_difference(ours, theirs), kRounding) << name;
  }
}

TEST(Engine, NamesReadBack) {
  for (const Engine engine : {Engine::kSimbody, Engine::kNative}) {
    EXPECT_EQ(engine_from_name(name(engine)), engine);
  }
  EXPECT_THAT([] { engine_from_name("mujoco"); },
              test::refused_at({.key = "engine", .value = "mujoco", .limit = "simbody or native"}));
}

}  // namespace native_plant_test
}  // namespace armtune::internal
