#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <random>

#include "core/common/cholesky6.hpp"
#include "core/common/lu6.hpp"
#include "core/common/products.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace small_solvers_test {

using Mat6 = Eigen::Matrix<double, 6, 6>;
using test::random_vector;
using test::WorstError;

Mat6 random_matrix(std::mt19937& generator) {
  Mat6 A;
  for (int j = 0; j < 6; ++j) A.col(j) = random_vector(generator, 6, 1.0);
  return A;
}

TEST(Lu6, SolvesAsEigenDoesAndHasItsDeterminant) {
  std::mt19937 generator(71);
  WorstError residual("A x = b", 1e-12);  // backward stable: of |A| |x|
  WorstError determinant("|det A|", 1e-12);
  for (int sample = 0; sample < 300; ++sample) {
    Mat6 A = random_matrix(generator);
    if (sample % 3 == 0) A(0, 0) = 0.0;  // no pivot where it begins
    if (sample % 3 == 1) A.row(5).swap(A.row(1));
    const Vec6 b = random_vector(generator, 6, 1.0);
    Lu6T<double> lu;
    lu.compute(Jacobian(A));
    JointVector x;
    lu.solve(b, x);
    residual.compare(Vec6(A * x), b, "random", 1.0 + x.norm());
    determinant.compare(lu.absolute_determinant(), std::abs(A.determinant()), "random", 1.0);
  }
}

TEST(Lu6, OfASingularMatrixHasADeterminantOfZero) {
  Jacobian A = Jacobian::Zero(6, 6);
  Lu6T<double> lu;
  lu.compute(A);
  EXPECT_EQ(lu.absolute_determinant(), 0.0);
  A.setIdentity(6, 6);
  A(3, 3) = 0.0;
  lu.compute(A);
  EXPECT_EQ(lu.absolute_determinant(), 0.0);
}

TEST(Cholesky6, SolvesAsEigenDoesAndHasTheRootOfItsDeterminant) {
  std::mt19937 generator(72);
  WorstError solution("A^-1 b", 1e-10);  // condition below 1e4 by the identity that is added
  WorstError root("sqrt(det A)", 1e-12);
  for (int sample = 0; sample < 300; ++sample) {
    const Mat6 B = random_matrix(generator);
    const Mat6 A = B * B.transpose() + 0.01 * Mat6::Identity();
    const Vec6 b = random_vector(generator, 6, 1.0);
    Cholesky6T<double> cholesky;
    cholesky.compute(A, 6);
    solution.compare(cholesky.solve(b), Vec6(A.llt().solve(b)), "random");
    root.compare(cholesky.root_of_determinant(), std::sqrt(A.determinant()), "random", 1.0);
    for (int n = 1; n < 6; ++n) {
      cholesky.compute(A, n);
      const Eigen::MatrixXd leading = A.topLeftCorner(n, n);
      root.compare(cholesky.root_of_determinant(), std::sqrt(leading.determinant()), "leading", 1.0);
    }
  }
}

TEST(Cholesky6, OfAMatrixThatIsNotPositiveHasARootOfZero) {
  Mat6 A = Mat6::Identity();
  A(2, 2) = -1.0;
  Cholesky6T<double> cholesky;
  cholesky.compute(A, 6);
  EXPECT_EQ(cholesky.root_of_determinant(), 0.0);
  cholesky.compute(Mat6::Zero(), 6);
  EXPECT_EQ(cholesky.root_of_determinant(), 0.0);
}

TEST(Products, AreEigensToRounding) {
  std::mt19937 generator(73);
  WorstError worst("products", 1e-14);
  for (int n = 1; n <= kMaxJoints; ++n) {
    Jacobian J(6, n);
    for (int j = 0; j < n; ++j) J.col(j) = random_vector(generator, 6, 1.0);
    const JointVector x = random_vector(generator, n, 1.0);
    const Vec6 y = random_vector(generator, 6, 1.0);
    worst.compare(times(J, x), Vec6(J * x), "J x", 1.0);
    JointVector back;
    transposed_times(J, y, back);
    worst.compare(back, JointVector(J.transpose() * y), "J^T y", 1.0);
    worst.compare(norm(x), x.norm(), "|x|", 1.0);
    const Mat3 A = random_matrix(generator).topLeftCorner<3, 3>();
    const Mat3 B = random_matrix(generator).topLeftCorner<3, 3>();
    worst.compare(Eigen::Vector3d(times(A, B).col(1)), Eigen::Vector3d((A * B).col(1)), "A B", 1.0);
    worst.compare(times(A, Vec3(B.col(0))), Vec3(A * B.col(0)), "R v", 1.0);
    worst.compare(transposed_times(A, Vec3(B.col(0))), Vec3(A.transpose() * B.col(0)), "R^T v", 1.0);
  }
}

}  // namespace small_solvers_test
}  // namespace armtune::internal
