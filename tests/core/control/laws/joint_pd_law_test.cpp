#include "core/control/laws/joint_pd_law.hpp"

#include <gtest/gtest.h>

#include "tests/core/support/law_period.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace joint_pd_law_test {

using test::Period;
using test::WorstError;

/// D (qr' - q') + g, what is left of the law where its reference is the arm.
JointVector without_spring(const Period& p) {
  return test::gravity_torque_at(p.model.chain, p.measured.q) -
         own(p.gains, "joint_pd_d").cwiseProduct(p.control.S);
}

TEST(JointPdLaw, BeginsWhereTheArmIs) {
  WorstError first("tau = g - D S", 1e-10);
  for (const RobotModel& model : test::all_arms()) {
    Period p(model, "joint_pd", 81);
    first.compare(p.torque(), without_spring(p), p.where());
  }
}

TEST(JointPdLaw, PullsTowardsTheIntegralOfTheReferenceVelocity) {
  WorstError pulled("tau = g + P (q_ref - q) - D S", 1e-10);
  for (const RobotModel& model : test::all_arms()) {
    Period p(model, "joint_pd", 82);
    JointVector q_ref = p.measured.q;
    for (int k = 0; k < 5; ++k) {
      const JointVector spring = own(p.gains, "joint_pd_p").cwiseProduct(q_ref - p.measured.q);
      pulled.compare(p.torque(), without_spring(p) + spring, p.where());
      p.law->conclude(true);
      q_ref += Period::period * p.control.reference.velocity;
      p.move();
    }
  }
}

TEST(JointPdLaw, ReferenceWaitsWhileAJointIsSaturatedAndYieldsToObstacles) {
  Period p(test::ur10(), "joint_pd", 83);
  const JointVector first = p.torque();
  p.law->conclude(false);
  EXPECT_EQ(p.torque(), first);
  p.law->conclude(true);
  EXPECT_NE(p.torque(), first);
  p.move();
  p.control.state = ControlState::kAvoidObstacles;
  EXPECT_LT((p.torque() - without_spring(p)).norm(), 1e-9 * first.norm());
}

}  // namespace joint_pd_law_test
}  // namespace armtune::internal
