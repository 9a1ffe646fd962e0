#include "core/control/joint_space_law.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace joint_space_law_test {

using test::random_vector;
using test::WorstError;

constexpr int kJoints = 7;

TEST(JointTrajectory, GoesFromRestAtTheStartToRestAtTheGoal) {
  std::mt19937 generator(521);
  const JointVector start = random_vector(generator, kJoints, 3.0);
  const JointVector goal = random_vector(generator, kJoints, 3.0);
  EXPECT_EQ(joint_trajectory(start, goal, 6.0, 0.0).position, start);
  EXPECT_TRUE(joint_trajectory(start, goal, 6.0, 6.0).position.isApprox(goal, 1e-14));
  for (const double t : {0.0, 6.0, 7.0}) {
    EXPECT_LT(joint_trajectory(start, goal, 6.0, t).velocity.norm(), 1e-14);
    EXPECT_LT(joint_trajectory(start, goal, 6.0, t).acceleration.norm(), 1e-14);
  }
}

TEST(JointTrajectory, VelocityAndAccelerationAreTheDerivatives) {
  std::mt19937 generator(522);
  const JointVector start = random_vector(generator, kJoints, 3.0);
  const JointVector goal = random_vector(generator, kJoints, 3.0);
  WorstError worst("derivative", 1e-10);  // of a quintic of a few seconds: 1e-15 / h of rounding
  for (const double t : {0.5, 2.0, 3.0, 5.5}) {
    const auto at = [&](double h) { return joint_trajectory(start, goal, 6.0, t + h); };
    worst.compare(at(0.0).velocity, test::derivative([&](double h) { return at(h).position; }), "velocity");
    worst.compare(at(0.0).acceleration, test::derivative([&](double h) { return at(h).velocity; }),
                  "acceleration", 1.0);
  }
}

TEST(JointSpaceReferences, AreTheEquationsJointByJoint) {
  std::mt19937 generator(523);
  WorstError worst("references", 1e-15);  // rounding
  for (int sample = 0; sample < 20; ++sample) {
    const MotionPoint<JointVector> d{random_vector(generator, kJoints, 3.0),
                                     random_vector(generator, kJoints, 2.0),
                                     random_vector(generator, kJoints, 4.0)};
    const JointVector Kp = random_vector(generator, kJoints, 10.0).cwiseAbs();
    const JointVector q = random_vector(generator, kJoints, 3.0);
    const JointVector qd = random_vector(generator, kJoints, 2.0);
    JointReference reference;
    joint_space_references(d, Kp, q, qd, reference);
    for (int i = 0; i < kJoints; ++i) {
      worst.compare(reference.velocity[i], d.velocity[i] - Kp[i] * (q[i] - d.position[i]), "qr'", 1.0);
      worst.compare(reference.acceleration[i], d.acceleration[i] - Kp[i] * (qd[i] - d.velocity[i]), "qr''",
                    1.0);
    }
  }
}

TEST(JointSpaceReferences, PointBackToTheDesiredPositionAndVelocity) {
  const JointVector zero = JointVector::Zero(2);
  const MotionPoint<JointVector> rest{zero, zero, zero};
  const JointVector Kp = JointVector::Constant(2, 5.0);
  const JointVector ahead = JointVector::Constant(2, 0.1);
  JointReference reference;
  joint_space_references(rest, Kp, ahead, zero, reference);
  EXPECT_TRUE((reference.velocity.array() < 0.0).all());
  joint_space_references(rest, Kp, zero, ahead, reference);
  EXPECT_TRUE((reference.acceleration.array() < 0.0).all());
}

}  // namespace joint_space_law_test
}  // namespace armtune::internal
