// When theta moves, and in what order.

#include <gtest/gtest.h>

#include <random>

#include "core/control/adaptation.hpp"
#include "core/control/controller.hpp"
#include "core/robot/theta.hpp"
#include "tests/core/support/controller_rig.hpp"
#include "tests/core/support/states.hpp"

namespace armtune {
namespace {

using test::obstacles_near;

/// One period of an arm whose theta would move for every reason: adaptation, leakage and projection.
struct RestlessTheta {
  test::Rig rig;
  std::unique_ptr<Controller> controller;
  double time = 0.0;

  explicit RestlessTheta(bool adapt_while_avoiding) {
    rig.gains.adaptation_leakage = 0.5;
    rig.gains.adaptation_projection = true;
    rig.gains.adapt_while_avoiding = adapt_while_avoiding;
    controller = rig.following(time);
    rig.p_0G += Vec3(0.03, 0.02, 0.0);
    for (int step = 0; step < 5; ++step) controller->update(rig.goal(), rig.scene(), time += rig.period);
  }
  /// Whether theta moved in a period.
  bool moves(const JointState& measured) {
    const ParameterVector before = controller->theta();
    controller->update(measured, rig.scene(), time += rig.period);
    return controller->theta() != before;
  }
};

TEST(ControllerOptions, ThetaNeitherLeaksNorIsProjectedWhileSaturated) {
  RestlessTheta theta(true);
  EXPECT_TRUE(theta.moves(theta.rig.goal()));
  JointState fast = theta.rig.goal();
  fast.qd << 5, -5, 5, 5, -5, 20;
  EXPECT_FALSE(theta.moves(fast));
  EXPECT_TRUE(theta.moves(theta.rig.goal()));
}

TEST(ControllerOptions, ThetaNeitherLeaksNorIsProjectedWhileItIsFrozenInAvoidance) {
  for (const bool adapt : {true, false}) {
    RestlessTheta theta(adapt);
    EXPECT_TRUE(theta.moves(theta.rig.goal()));
    theta.rig.obstacles = {obstacles_near(theta.rig)[0]};
    EXPECT_EQ(theta.moves(theta.rig.goal()), adapt);
    theta.rig.obstacles.clear();
    EXPECT_TRUE(theta.moves(theta.rig.goal()));
  }
}

TEST(ControllerOptions, ThetaStepsLeaksAndIsProjectedInThisOrder) {
  test::Rig rig;
  rig.gains.adaptation_gain = 5.0;
  rig.gains.adaptation_leakage = 0.5;
  rig.gains.adaptation_projection = true;
  const ParameterVector start = 0.5 * theta_of(rig.model->chain);
  const std::unique_ptr<Controller> controller = rig.controller(start);
  JointState measured = rig.goal();
  std::mt19937 generator(773);
  Adaptation expected(start);
  for (int step = 0; step < 100; ++step) {
    measured.qd = test::random_vector(generator, 6, 0.3);
    const ControlOutput& out = controller->update(measured, rig.scene(), step * rig.period);
    ASSERT_FALSE(out.saturated);
    SlotineLi motion;
    slotine_li_forward(rig.model->chain, test::poses_at(rig.model->chain, measured.q), measured.qd,
                       out.reference.velocity, out.reference.acceleration, motion);
    expected.step(motion, 5.0, rig.period);
    expected.leak(0.5, rig.period);
    expected.project();
    EXPECT_EQ(controller->theta(), expected.theta()) << step;
  }
}

}  // namespace
}  // namespace armtune
