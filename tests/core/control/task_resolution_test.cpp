#include "core/control/task_resolution.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <random>

#include "tests/core/support/law_period.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace task_resolution_test {

using test::random_vector;
using test::rows_of;
using test::WorstError;

constexpr double kPsi = 0.05;

/// Every arm with every task that it has joints for.
struct Case {
  RobotModel arm;
  TaskMask mask;
  std::string name() const { return arm.name + ", " + armtune::internal::name(mask); }
};
std::vector<Case> all_cases() {
  std::vector<Case> cases;
  auto arms = test::all_arms();
  for (const int n : {4, 5, 8}) arms.push_back(test::random_arm(n, static_cast<unsigned>(40 + n), n == 8));
  for (const RobotModel& arm : arms) {
    for (const TaskMask mask : {TaskMask::kPose, TaskMask::kPositionAndAxis, TaskMask::kPosition}) {
      if (components(mask) <= arm.n()) cases.push_back({arm, mask});
    }
  }
  return cases;
}

/// A state and a reference that move: everything as a function of time along q(t) = q + q' t + q'' t^2 / 2.
struct Motion {
  Motion(const Case& c, std::mt19937& generator)
      : mask(c.mask),
        q(test::random_configuration(generator, c.arm)),
        qd(random_vector(generator, c.arm.n(), 1.0)),
        qdd(random_vector(generator, c.arm.n(), 1.0)),
        rate(random_vector(generator, 6, 1.0)),
        acceleration(random_vector(generator, 6, 1.0)),
        centering{random_vector(generator, c.arm.n(), 1.0),
                  random_vector(generator, c.arm.n(), 2.0).cwiseAbs()} {}

  /// Measured and resolved at t.
  void at(const Chain& chain, double t, const InverseDamping& damping) {
    const JointVector now = q + t * qd + 0.5 * t * t * qdd;
    const JointVector speed = qd + t * qdd;
    arm.measure(chain, now, speed, damping, mask);
    arm.differentiate(chain, speed);
    reference_task.rate = rate + t * acceleration;
    reference_task.acceleration = acceleration;
    resolve(reference_task, arm, centering, now, speed, reference);
  }

  TaskMask mask;
  JointVector q, qd, qdd;
  Vec6 rate, acceleration;
  JointCentering centering;
  MeasuredArm arm;
  TaskReference reference_task;
  JointReference reference;
};

TEST(TaskResolution, HoldsTheTasksComponents) {
  std::mt19937 generator(541);
  WorstError worst("E J qr' = E xr'", 1e-8);  // condition of J J^T above the threshold
  for (const Case& c : all_cases()) {
    int exact = 0;
    for (int sample = 0; sample < 50; ++sample) {
      Motion m(c, generator);
      m.at(c.arm.chain, 0.0, {1e-3, kPsi});
      if (m.arm.inverse.damped()) continue;
      ++exact;
      const Eigen::MatrixXd E = rows_of(c.mask, m.arm.poses.R_0T);
      worst.compare(Eigen::VectorXd(E * m.arm.J * m.reference.velocity), Eigen::VectorXd(E * m.rate),
                    c.name());
    }
    EXPECT_GT(exact, 0) << c.name();
  }
}

TEST(TaskResolution, IsOfAllMotionsThatHoldTheTaskTheOneClosestToTheCentering) {
  std::mt19937 generator(542);
  WorstError closest("qr' - z is J+ (xr' - J z)", 1e-8);
  WorstError pulls("z", 1e-15);
  for (const Case& c : all_cases()) {
    for (int sample = 0; sample < 20; ++sample) {
      Motion m(c, generator);
      m.at(c.arm.chain, 0.0, {1e-3, kPsi});
      if (m.arm.inverse.damped() || m.arm.inverse.is_square()) continue;
      JointVector z(c.arm.n());
      for (int i = 0; i < c.arm.n(); ++i) z[i] = -m.centering.rate[i] * (m.q[i] - m.centering.middle[i]);
      pulls.compare(m.centering.velocity(m.q), z, c.name());
      const Eigen::MatrixXd EJ = rows_of(c.mask, m.arm.poses.R_0T) * m.arm.J;
      const Eigen::MatrixXd plus =
          Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(EJ).pseudoInverse();
      const Eigen::VectorXd rest = rows_of(c.mask, m.arm.poses.R_0T) * m.rate - EJ * z;
      closest.compare(Eigen::VectorXd(m.reference.velocity - z), Eigen::VectorXd(plus * rest), c.name());
    }
  }
}

TEST(TaskResolution, TheAccelerationIsTheVelocitysDerivativeAlongTheMotion) {
  std::mt19937 generator(543);
  // Central differences: h^2 of the third derivative, which grows with the inverse, and rounding over h.
  WorstError worst("qr'' = d qr' / dt", 2e-5);
  constexpr double kStep = 1e-5;
  for (const Case& c : all_cases()) {
    int exact = 0;
    for (int sample = 0; sample < 50; ++sample) {
      Motion m(c, generator);
      m.at(c.arm.chain, 0.0, {0.02, kPsi});
      if (m.arm.inverse.damped()) continue;
      ++exact;
      const JointVector acceleration = m.reference.acceleration;
      m.at(c.arm.chain, kStep, {0.0, kPsi});
      const JointVector after = m.reference.velocity;
      m.at(c.arm.chain, -kStep, {0.0, kPsi});
      const JointVector slope = (after - m.reference.velocity) / (2.0 * kStep);
      worst.compare(acceleration, slope, c.name(), 1.0 + slope.norm());
    }
    EXPECT_GT(exact, 0) << c.name();
  }
}

TEST(TaskResolution, DampedItIsTheDampedFormula) {
  std::mt19937 generator(544);
  WorstError velocity("qr'", 1e-11);
  WorstError acceleration("J^T (..)^-1 of what is left", 1e-11);
  for (const Case& c : all_cases()) {
    Motion m(c, generator);
    m.centering.rate.setZero();
    m.at(c.arm.chain, 0.0, {1e9, kPsi});
    ASSERT_TRUE(m.arm.inverse.damped());
    const Eigen::MatrixXd EJ = rows_of(c.mask, m.arm.poses.R_0T) * m.arm.J;
    const Eigen::MatrixXd JJt = EJ * EJ.transpose() + kPsi * Eigen::MatrixXd::Identity(EJ.rows(), EJ.rows());
    const Eigen::VectorXd taken = rows_of(c.mask, m.arm.poses.R_0T) * m.rate;
    velocity.compare(Eigen::VectorXd(m.reference.velocity),
                     Eigen::VectorXd(EJ.transpose() * JJt.inverse() * taken), c.name());
    if (!m.arm.inverse.is_square()) continue;
    const Vec6 rest = m.acceleration - m.arm.J_dot * m.reference.velocity;
    acceleration.compare(Eigen::VectorXd(m.reference.acceleration),
                         Eigen::VectorXd(EJ.transpose() * JJt.inverse() * rest), c.name());
  }
}

TEST(TaskResolution, CenteringMovesTheFreeJointsUntilNothingDrawsThemAndLeavesTheToolAlone) {
  const RobotModel arm = test::seven_joint_arm();
  JointVector q(7);
  q << 0.5, 0.8, -0.6, 1.2, 0.3, -0.9, 0.4;
  const JointVector start = q;
  const JointCentering centering{JointVector::Zero(7), JointVector::Ones(7)};
  const Poses before = test::poses_at(arm.chain, q);
  MeasuredArm measured;
  JointVector velocity = JointVector::Zero(7);
  double fastest = 0.0;
  for (int k = 0; k < 40000; ++k) {
    measured.measure(arm.chain, q, velocity, {0.0, kPsi}, TaskMask::kPose);
    resolve_velocity(Vec6(Vec6::Zero()), measured, centering, q, velocity);
    fastest = std::max(fastest, velocity.norm());
    q += 1e-3 * velocity;
  }
  EXPECT_GT(fastest, 0.04) << "rad/s";
  EXPECT_LT(velocity.norm(), 1e-3 * fastest);
  EXPECT_LT(q.norm(), start.norm()) << "nearer to the middle";
  // But for the steps' length: half of h q'' a second.
  EXPECT_LT((measured.poses.p_0T - before.p_0T).norm(), 1e-3);
  EXPECT_LT((measured.poses.R_0T - before.R_0T).norm(), 1e-3);
}

}  // namespace task_resolution_test
}  // namespace armtune::internal
