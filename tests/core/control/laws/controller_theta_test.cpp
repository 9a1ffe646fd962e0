// When theta moves, and in what order.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/control/adaptation.hpp"
#include "core/control/laws/controller.hpp"
#include "core/robot/theta.hpp"
#include "tests/core/support/controller_rig.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace controller_theta_test {

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
  rig.gains.adaptation_inertia_leakage = 0.25;
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
    expected.step(motion, motion, 5.0, rig.period);
    expected.leak(0.5, 0.25, rig.period);
    expected.project();
    EXPECT_EQ(controller->theta(), expected.theta()) << step;
  }
}

/// First-order low-pass of every number of the motion, written out, in states that track joints and the tool.
TEST(ControllerOptions, ThetaAdaptsAlongTheFilteredMotion) {
  constexpr double kCorner = 5.0;  // Hz
  test::Rig rig;
  rig.gains.adaptation_filter = kCorner;
  rig.gains.adaptation_gain = 0.5;
  rig.path.frequency = 0.5;
  rig.path.terms = {{1, Vec3(0.05, 0, 0), Vec3(0, 0.05, 0)}};
  const Chain& chain = rig.model->chain;
  const std::unique_ptr<Controller> controller = rig.controller(0.5 * theta_of(chain));
  std::mt19937 generator(774);
  Adaptation expected(0.5 * theta_of(chain));
  test::WorstError worst("theta", 1e-12);  // rounding
  const double share = 1.0 - std::exp(-2.0 * M_PI * kCorner * rig.period);
  JointVector qd = JointVector::Zero(6);
  JointVector qdr = JointVector::Zero(6);
  JointVector qddr = JointVector::Zero(6);
  int joints = 0;
  int tool = 0;
  for (int step = 0; step < 600; ++step) {
    const JointState measured{rig.goal().q + test::random_vector(generator, 6, 0.02),
                              test::random_vector(generator, 6, 0.02)};
    const ControlOutput& out = controller->update(measured, rig.scene(), step * rig.period);
    ASSERT_FALSE(out.saturated);
    ++(tracks_joints(out.state) ? joints : tool);
    qd += share * (measured.qd - qd);
    qdr += share * (out.reference.velocity - qdr);
    qddr += share * (out.reference.acceleration - qddr);
    const Poses poses = test::poses_at(chain, measured.q);
    SlotineLi along;
    SlotineLi motion;
    slotine_li_forward(chain, poses, qd, qdr, qddr, along);
    slotine_li_forward(chain, poses, measured.qd, out.reference.velocity, out.reference.acceleration, motion);
    expected.step(along, motion, 0.5, rig.period);
    worst.compare(controller->theta(), expected.theta(), std::to_string(step));
  }
  EXPECT_GT(joints, 100);
  EXPECT_GT(tool, 100);
}

}  // namespace controller_theta_test
}  // namespace armtune::internal
