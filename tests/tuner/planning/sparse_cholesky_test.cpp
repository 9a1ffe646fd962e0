#include "tuner/planning/solver/sparse_cholesky.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "tuner/quadratic/dense_cholesky.hpp"

namespace armtune::internal {
namespace sparse_cholesky_test {

/// Returns the upper triangle of an arrow matrix: a diagonal, and a last column without zeros.
SymmetricMatrix arrow(int size) {
  SymmetricMatrix K;
  K.size = size;
  K.column_starts = {0};
  for (int c = 0; c < size; ++c) {
    for (int r = c + 1 < size ? c : 0; r <= c; ++r) {
      K.rows.push_back(r);
      K.values.push_back(r == c ? 3.0 + c : 1.0 / (1.0 + r));
    }
    K.column_starts.push_back(static_cast<int>(K.rows.size()));
  }
  return K;
}

TEST(SparseCholesky, SolvesAsTheDenseOneDoes) {
  const SymmetricMatrix K = arrow(7);
  const auto sparse = make_sparse_cholesky(K);
  const auto dense = make_dense_cholesky(K);
  ASSERT_TRUE(sparse->factorize(K));
  ASSERT_TRUE(dense->factorize(K));
  Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(7, -1.0, 1.0);
  Eigen::VectorXd y = x;
  sparse->solve(x);
  dense->solve(y);
  EXPECT_LE((x - y).norm(), 1e-14);
  EXPECT_GT(x.norm(), 0.1);
}

TEST(SparseCholesky, SaysThatAMatrixIsNotPositiveDefinite) {
  SymmetricMatrix K;
  K.size = 2;
  K.column_starts = {0, 1, 3};
  K.rows = {0, 0, 1};
  K.values = {1.0, 2.0, 1.0};
  SparseCholesky cholesky(K);
  EXPECT_FALSE(cholesky.factorize(K));
  K.values = {1.0, 0.5, 1.0};
  EXPECT_TRUE(cholesky.factorize(K));
}

}  // namespace sparse_cholesky_test
}  // namespace armtune::internal
