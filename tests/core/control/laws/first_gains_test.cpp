#include "core/control/laws/first_gains.hpp"

#include <gtest/gtest.h>

#include "core/robot/forward_dynamics.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace first_gains_test {

using test::WorstError;

// By articulated bodies, which form no M: an inertia is what divides a force along one coordinate, the others
// free.
TEST(FirstGains, InertiasAreThoseThatAForceMeets) {
  std::mt19937 generator(91);
  WorstError joints("joint", 1e-9), task("task", 1e-9);
  for (const RobotModel& arm : test::all_arms()) {
    const int n = arm.n();
    const JointVector q = test::random_configuration(generator, arm);
    const JointVector rest = JointVector::Zero(n);
    const Poses poses = test::poses_at(arm.chain, q);
    const auto acceleration = [&](const JointVector& tau) {
      ForwardDynamics work;
      JointVector qdd;
      forward_dynamics(arm.chain, poses, rest, tau, work, qdd);
      return qdd;
    };
    const JointVector falls = acceleration(rest);
    const JointVector inertia = joint_inertia(arm, q);
    for (int i = 0; i < n; ++i) {
      const double moved = (acceleration(JointVector(JointVector::Unit(n, i))) - falls)[i];
      joints.compare(inertia[i], 1.0 / moved, arm.name);
    }
    const Jacobian J = test::tool_jacobian_at(arm.chain, q);
    const Vec6 at_tool = task_inertia(arm, q);
    for (int axis = 0; axis < 6; ++axis) {
      const JointVector tau = J.transpose() * Vec6(Vec6::Unit(axis));
      task.compare(at_tool[axis], 1.0 / (J * (acceleration(tau) - falls))[axis], arm.name);
    }
  }
}

TEST(FirstGains, AnAxisThatNothingMovesFeelsNothing) {
  // Two joints turned about the same vertical axis move the tool in the plane only.
  RobotModel arm = test::random_arm(3, 5, false);
  for (std::size_t k = 0; k < 3; ++k) {
    arm.chain.R_PB0[k].setIdentity();
    arm.chain.p_PB0[k] = Vec3(0.3, 0.0, 0.0);
  }
  arm.chain.p_BT = Vec3(0.2, 0.0, 0.0);
  const Vec6 inertia = task_inertia(arm, JointVector(JointVector::Constant(3, 0.4)));
  EXPECT_GT(inertia[0], 0.0);
  EXPECT_GT(inertia[1], 0.0);
  EXPECT_EQ(inertia[2], 0.0);
  EXPECT_EQ(inertia[3], 0.0);
  EXPECT_EQ(inertia[4], 0.0);
  EXPECT_GT(inertia[5], 0.0);
}

TEST(FirstGains, ReferencesThatAreThereStay) {
  Gains gains;
  first_references(gains);
  EXPECT_GT(gains.task_space_gains_p.minCoeff(), 0.0);
  EXPECT_GT(gains.task_space_gains_i.minCoeff(), 0.0);
  gains.task_space_gains_p << 1, 2, 3, 4, 5, 6;
  gains.task_space_gains_i.setZero();
  first_references(gains);
  EXPECT_EQ(gains.task_space_gains_p[5], 6.0);
  EXPECT_TRUE(gains.task_space_gains_i.isZero(0.0));
}

}  // namespace first_gains_test
}  // namespace armtune::internal
