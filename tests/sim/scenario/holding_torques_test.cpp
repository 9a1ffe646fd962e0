#include "sim/scenario/holding_torques.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "armtune/error.hpp"
#include "core/robot/dynamics.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal {
namespace holding_torques_test {

using test::refused_at;
using testing::HasSubstr;

constexpr double kMost = 0.85;

RobotModel with_efforts(RobotModel arm, double factor) {
  for (JointInfo& joint : arm.joints) joint.limits.effort *= factor;
  return arm;
}

JointVector gravity_at(const RobotModel& arm, const JointVector& q) {
  JointVector torque;
  gravity_torque(arm.chain, test::poses_at(arm.chain, q), torque);
  return torque;
}

TEST(HeaviestHolds, NoRandomPositionTakesMuchMore) {
  std::mt19937 generator(21);
  for (const RobotModel& arm : test::all_arms()) {
    const std::vector<JointHold> found = heaviest_holds(arm);
    ASSERT_EQ(found.size(), static_cast<std::size_t>(arm.n()));
    for (int i = 0; i < arm.n(); ++i) {
      const JointHold& hold = found[static_cast<std::size_t>(i)];
      EXPECT_EQ(hold.joint, i);
      EXPECT_NEAR(std::abs(gravity_at(arm, hold.q)[i]), hold.torque, 1e-9);
      for (int sample = 0; sample < 200; ++sample) {
        const JointVector q = test::random_configuration(generator, arm);
        EXPECT_LE(std::abs(gravity_at(arm, q)[i]), 1.05 * hold.torque + 1e-9) << arm.name << ", joint " << i;
      }
    }
  }
}

// The second joint of this random arm slides, and bears most of the arm.
TEST(RefuseTooHeavy, AnArmThatCanHoldItselfAlmostNowhereIsRefusedWithTorqueAndLimit) {
  EXPECT_NO_THROW(refuse_too_heavy(with_efforts(test::ur10(), 0.2), kMost));
  const InputError error =
      test::input_error([] { refuse_too_heavy(with_efforts(test::ur10(), 0.1), kMost); });
  EXPECT_THAT(error,
              refused_at({.key = "shoulder_lift_joint/effort", .value = "33", .limit = HasSubstr("above ")}));
  // More than half of all positions take more than the limit of 33 N m.
  EXPECT_GT(std::atof(error.limit().c_str() + 6), 33.0);
  EXPECT_THAT(error.what(), HasSubstr(error.limit().substr(6) + " N m to hold the arm"));

  const RobotModel slides = test::random_arm(6, 1001, true);
  const InputError of_slide = test::input_error([&] { refuse_too_heavy(slides, kMost); });
  EXPECT_THAT(of_slide, refused_at({.key = slides.joints[1].name + "/effort"}));
  EXPECT_THAT(of_slide.what(), HasSubstr(of_slide.limit().substr(6) + " N to hold the arm"));
}

TEST(RefuseTooHeavy, CountsThePositionsThatTheArmCanHold) {
  std::mt19937 generator(22);
  const RobotModel arm = test::ur10();
  for (const double factor : {0.06, 0.08, 0.14, 0.2}) {
    const RobotModel weak = with_efforts(arm, factor);
    int held = 0;
    constexpr int kSamples = 4000;
    for (int sample = 0; sample < kSamples; ++sample) {
      JointVector q = test::random_configuration(generator, weak);
      const JointVector share = gravity_at(weak, q).cwiseAbs().cwiseQuotient(weak.effort_limits());
      held += share.maxCoeff() <= kMost ? 1 : 0;
    }
    bool refused = false;
    try {
      refuse_too_heavy(weak, kMost);
    } catch (const InputError&) {
      refused = true;
    }
    EXPECT_EQ(refused, held < kSamples / 20) << factor << ": " << held;
  }
}

}  // namespace holding_torques_test
}  // namespace armtune::internal
