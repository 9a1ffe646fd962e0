#include "core/control/task_inverse.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>
#include <random>

#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace task_inverse_test {

using test::WorstError;

constexpr double kThreshold = 0.01;  // low enough for every arm here to be above and below it
constexpr double kPsi = 0.05;
constexpr int kSamples = 100;

/// J+ as a matrix, column by column.
Eigen::MatrixXd matrix_of(const TaskInverse& inverse, Eigen::Index n) {
  Eigen::MatrixXd X(n, 6);
  for (int i = 0; i < 6; ++i) {
    JointVector x;
    inverse.apply(Vec6::Unit(i), x);
    X.col(i) = x;
  }
  return X;
}

double manipulability_by_singular_values(const Jacobian& J) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(J).singularValues().prod();
}

TEST(TaskInverse, ManipulabilityIsTheRootOfTheDeterminant) {
  std::mt19937 generator(501);
  // The root of a determinant that rounds at 1e-16 errs by 1e-16 / 2m, which an m of 1e-5 turns into 5e-12:
  // 5e-9 of the floor.
  WorstError worst("m", 1e-8);
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const Jacobian J = test::tool_jacobian_at(arm.chain, test::random_configuration(generator, arm));
      TaskInverse inverse;
      inverse.compute(J, {kThreshold, kPsi});
      worst.compare(inverse.manipulability(), manipulability_by_singular_values(J), arm.name, 1e-3);
    }
  }
}

TEST(TaskInverse, IsThePseudoInverseAboveTheThresholdForSixJointsAndMore) {
  std::mt19937 generator(502);
  WorstError identity("J J+ = 1", 1e-9);  // condition of J J^T
  WorstError minimum_norm("J+", 1e-9);    // Eigen's minimum-norm solution, the same rounding
  for (const RobotModel& arm : test::all_arms()) {
    if (arm.n() < 6) continue;
    int above = 0;
    for (int sample = 0; sample < kSamples; ++sample) {
      const Jacobian J = test::tool_jacobian_at(arm.chain, test::random_configuration(generator, arm));
      TaskInverse inverse;
      inverse.compute(J, {kThreshold, kPsi});
      EXPECT_EQ(inverse.damped(), inverse.manipulability() < kThreshold) << arm.name;
      if (inverse.damped()) continue;
      ++above;
      const Eigen::MatrixXd X = matrix_of(inverse, J.cols());
      identity.compare(Eigen::MatrixXd(J * X), Eigen::MatrixXd(Eigen::MatrixXd::Identity(6, 6)), arm.name);
      minimum_norm.compare(
          X, Eigen::MatrixXd(Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(J).pseudoInverse()),
          arm.name);
    }
    EXPECT_GT(above, 0) << arm.name;
  }
}

TEST(TaskInverse, IsTheDampedFormulaBelowTheThreshold) {
  std::mt19937 generator(503);
  WorstError worst("damped J+", 1e-12);  // psi keeps the condition below 1e3
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const Jacobian J = test::tool_jacobian_at(arm.chain, test::random_configuration(generator, arm));
      const double threshold = 1.01 * manipulability_by_singular_values(J) + 1e-9;
      TaskInverse inverse;
      inverse.compute(J, {threshold, kPsi});
      EXPECT_TRUE(inverse.damped()) << arm.name;
      const Eigen::MatrixXd JJt = J * J.transpose() + kPsi * Eigen::MatrixXd::Identity(6, 6);
      worst.compare(matrix_of(inverse, J.cols()), Eigen::MatrixXd(J.transpose() * JJt.inverse()), arm.name);
    }
  }
}

TEST(TaskInverse, SwitchesExactlyAtTheThreshold) {
  const Jacobian J = test::tool_jacobian_at(test::ur10().chain, JointVector::Constant(6, 0.7));
  TaskInverse inverse;
  inverse.compute(J, {0.0, kPsi});
  const double m = inverse.manipulability();
  inverse.compute(J, {m, kPsi});
  EXPECT_FALSE(inverse.damped());
  inverse.compute(J, {std::nextafter(m, 1.0), kPsi});
  EXPECT_TRUE(inverse.damped());
}

TEST(TaskInverse, VariableDampingIsContinuousAtTheThresholdAndWholeAtASingularity) {
  const Jacobian J = test::tool_jacobian_at(test::ur10().chain, JointVector::Constant(6, 0.7));
  TaskInverse inverse;
  inverse.compute(J, {0.0, kPsi});
  const double m = inverse.manipulability();
  const Eigen::MatrixXd exact = matrix_of(inverse, 6);
  // psi = kPsi * 1e-12 just below the threshold; switched on as a whole it changes the inverse by far more.
  inverse.compute(J, {m * (1.0 + 1e-6), kPsi, true});
  EXPECT_TRUE(inverse.damped());
  EXPECT_LT((matrix_of(inverse, 6) - exact).norm(), 1e-9 * exact.norm());
  inverse.compute(J, {m * (1.0 + 1e-6), kPsi, false});
  EXPECT_GT((matrix_of(inverse, 6) - exact).norm(), 1e-2 * exact.norm());

  const Eigen::MatrixXd half =
      J.transpose() * (J * J.transpose() + 0.25 * kPsi * Eigen::MatrixXd::Identity(6, 6)).inverse();
  inverse.compute(J, {2.0 * m, kPsi, true});
  EXPECT_LT((matrix_of(inverse, 6) - half).norm(), 1e-12 * half.norm());

  const Jacobian singular = test::tool_jacobian_at(test::ur10().chain, JointVector::Zero(6));
  inverse.compute(singular, {0.1, kPsi, false});
  const Eigen::MatrixXd whole = matrix_of(inverse, 6);
  inverse.compute(singular, {0.1, kPsi, true});
  EXPECT_LT((matrix_of(inverse, 6) - whole).norm(), 1e-5 * whole.norm());
}

TEST(TaskInverse, IsAlwaysDampedWithFewerThanSixJoints) {
  const RobotModel arm = test::random_arm(3, 13, false);
  const Jacobian J = test::tool_jacobian_at(arm.chain, JointVector::Constant(3, 0.7));
  TaskInverse inverse;
  inverse.compute(J, {0.0, kPsi});
  EXPECT_TRUE(inverse.damped());
  EXPECT_GT(inverse.manipulability(), 0.0);
}

TEST(TaskInverse, IsFiniteAtASingularity) {
  // The stretched UR10 has lost rank.
  for (const RobotModel& arm : {test::ur10(), test::seven_joint_arm()}) {
    const Jacobian J = test::tool_jacobian_at(arm.chain, JointVector::Zero(arm.n()));
    TaskInverse inverse;
    inverse.compute(J, {0.1, kPsi});
    EXPECT_TRUE(inverse.damped());
    EXPECT_LT(inverse.manipulability(), 1e-6);
    EXPECT_TRUE(matrix_of(inverse, arm.n()).allFinite());
  }
}

}  // namespace task_inverse_test
}  // namespace armtune::internal
