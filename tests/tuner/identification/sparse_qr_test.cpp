#include "tuner/identification/sparse_qr.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace sparse_qr_test {

using test::WorstError;

Eigen::MatrixXd random_matrix(std::mt19937& generator, int rows, int columns, double density) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::bernoulli_distribution there(density);
  Eigen::MatrixXd A(rows, columns);
  for (double& x : A.reshaped()) x = there(generator) ? uniform(generator) : 0.0;
  return A;
}

SparseMatrix sparse(const Eigen::MatrixXd& A) {
  return A.sparseView();
}

TEST(TriangularFactor, IsUpperTriangularAndKeepsTheInnerProducts) {
  std::mt19937 generator(811);
  WorstError worst("R^T R", 1e-13);  // rounding
  for (const int rows : {5, 40, 300}) {
    const Eigen::MatrixXd A = random_matrix(generator, rows, 20, 0.4);
    const Eigen::MatrixXd R = triangular_factor(sparse(A));
    ASSERT_EQ(R.rows(), 20);
    EXPECT_TRUE(R.isUpperTriangular(0.0));
    worst.compare(Eigen::MatrixXd(R.transpose() * R), Eigen::MatrixXd(A.transpose() * A), "random");
  }
}

TEST(RankRevealingFactor, CallsAColumnDeadThatDependsOnThoseBeforeIt) {
  std::mt19937 generator(812);
  WorstError worst("dead from live", 1e-12);  // rounding times the condition of random columns
  for (int sample = 0; sample < 20; ++sample) {
    Eigen::MatrixXd A = random_matrix(generator, 60, 8, 0.8);
    A.col(3) = 2.0 * A.col(0) - A.col(2);
    A.col(5).setZero();
    A.col(7) = A.col(1) + A.col(3) - 0.5 * A.col(6);
    const RankRevealed revealed = rank_revealing_factor(sparse(A), 1e-9);
    EXPECT_EQ(revealed.live, (std::vector<int>{0, 1, 2, 4, 6}));
    EXPECT_EQ(revealed.dead, (std::vector<int>{3, 5, 7}));
    const Eigen::MatrixXd combination =
        revealed.R.leftCols(5).triangularView<Eigen::Upper>().solve(revealed.R.rightCols(3));
    for (Eigen::Index d = 0; d < 3; ++d) {
      Eigen::VectorXd column = Eigen::VectorXd::Zero(60);
      for (Eigen::Index l = 0; l < 5; ++l) {
        column += combination(l, d) * A.col(revealed.live[static_cast<std::size_t>(l)]);
      }
      worst.compare(column, Eigen::VectorXd(A.col(revealed.dead[static_cast<std::size_t>(d)])), "random",
                    1.0);
    }
  }
}

}  // namespace sparse_qr_test
}  // namespace armtune::internal
