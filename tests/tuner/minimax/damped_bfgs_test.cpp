#include "tuner/minimax/damped_bfgs.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstdlib>

namespace armtune::internal {
namespace damped_bfgs_test {

using Eigen::MatrixXd;
using Eigen::VectorXd;

double least_eigenvalue(const MatrixXd& B) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(B).eigenvalues().minCoeff();
}

TEST(DampedBfgs, ReproducesTheChangeOfTheGradientWhereTheCurvatureIsPositive) {
  MatrixXd B(2, 2);
  B << 2.0, 0.3, 0.3, 1.0;
  const VectorXd s = VectorXd::LinSpaced(2, 0.1, -0.2);
  VectorXd y(2);
  y << 0.5, -0.4;
  ASSERT_GT(s.dot(y), 0.2 * s.dot(B * s));
  update_damped_bfgs(B, s, y);
  EXPECT_LE((B * s - y).norm(), 1e-14);
  EXPECT_LE((B - B.transpose()).norm(), 1e-15);
}

TEST(DampedBfgs, LeavesAFifthOfTheCurvatureWhereTheGradientFalls) {
  MatrixXd B = MatrixXd::Identity(3, 3);
  const VectorXd s = VectorXd::LinSpaced(3, 0.1, 0.3);
  const double before = s.dot(B * s);
  update_damped_bfgs(B, s, -5.0 * s);
  EXPECT_NEAR(s.dot(B * s), 0.2 * before, 1e-14);
  EXPECT_GT(least_eigenvalue(B), 0.0);
}

TEST(DampedBfgs, StaysPositiveDefiniteWhateverTheCurvatureIs) {
  std::srand(3);
  MatrixXd B = MatrixXd::Identity(6, 6);
  for (int k = 0; k < 20; ++k) {
    const MatrixXd root = MatrixXd::Random(6, 6);
    const VectorXd s = 0.1 * VectorXd::Random(6);
    update_damped_bfgs(B, s, (root + root.transpose()) * s);
    ASSERT_GT(least_eigenvalue(B), 0.0) << k;
  }
}

TEST(DampedBfgs, LearnsAQuadraticFunctionFromItsSteps) {
  std::srand(5);
  const MatrixXd root = MatrixXd::Random(4, 4);
  const MatrixXd Q = root * root.transpose() + MatrixXd::Identity(4, 4);
  MatrixXd B = MatrixXd::Identity(4, 4);
  for (int k = 0; k < 200; ++k) {
    const VectorXd s = VectorXd::Random(4);
    update_damped_bfgs(B, s, Q * s);
  }
  EXPECT_LE((B - Q).norm(), 1e-6 * Q.norm());
}

TEST(DampedBfgs, AStepOfNoLengthAndAGradientThatIsNotANumberChangeNothing) {
  MatrixXd B = 2.0 * MatrixXd::Identity(2, 2);
  update_damped_bfgs(B, VectorXd::Zero(2), VectorXd::Ones(2));
  update_damped_bfgs(B, VectorXd::Ones(2), VectorXd::Constant(2, NAN));
  EXPECT_EQ(B, (2.0 * MatrixXd::Identity(2, 2)).eval());
}

}  // namespace damped_bfgs_test
}  // namespace armtune::internal
