#include "tuner/quadratic/interior_point.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>

#include "tests/tuner/support/dense_program.hpp"

namespace armtune::internal {
namespace interior_point_test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::DenseProgram;
constexpr double kInf = std::numeric_limits<double>::infinity();

/// Conditions of Karush, Kuhn and Tucker, written out: what makes x the optimum of a convex program.
void expect_optimal(const DenseProgram& dense, const VectorXd& x, const VectorXd& y, double tolerance) {
  const RowBounds& bounds = dense.program.bounds;
  EXPECT_LE((dense.H() * x + dense.program.gradient + dense.G_full.transpose() * y).lpNorm<Eigen::Infinity>(),
            tolerance);
  const VectorXd value = dense.G_full * x;
  for (Index i = 0; i < y.size(); ++i) {
    const double over = std::max(0.0, value[i] - bounds.upper[i]);
    const double under = std::max(0.0, bounds.lower[i] - value[i]);
    if (!std::isfinite(bounds.penalty[i])) {
      EXPECT_LE(over, tolerance);
      EXPECT_LE(under, tolerance);
    }
    // A violated row pulls with its whole penalty, and no row with more.
    EXPECT_LE(std::abs(y[i]), bounds.penalty[i] * (1.0 + 1e-9));
    if (over > 1e-6) {
      EXPECT_NEAR(y[i], bounds.penalty[i], 1e-4 * bounds.penalty[i]);
    }
    if (under > 1e-6) {
      EXPECT_NEAR(y[i], -bounds.penalty[i], 1e-4 * bounds.penalty[i]);
    }
    // A row away from a bound does not pull at it.
    if (y[i] > 1e-4) {
      EXPECT_GE(value[i], bounds.upper[i] - 1e-4);
    }
    if (y[i] < -1e-4) {
      EXPECT_LE(value[i], bounds.lower[i] + 1e-4);
    }
  }
}

TEST(InteriorPoint, SatisfiesTheOptimalityConditionsOfRandomPrograms) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::srand(seed);
    const Index n = 3 + seed % 6;
    const Index m = 2 + seed % 9;
    const MatrixXd root = MatrixXd::Random(n, n);
    DenseProgram dense(MatrixXd::Random(n + 1, n), root * root.transpose() * 0.3, MatrixXd::Random(m, n));
    dense.program.gradient = 3.0 * VectorXd::Random(n);
    dense.program.damping = VectorXd::Constant(n, 0.1);
    RowBounds& bounds = dense.program.bounds;
    for (Index i = 0; i < m; ++i) {
      bounds.lower[i] = i % 3 == 1 ? -kInf : -0.1 - 0.05 * static_cast<double>(i);
      bounds.upper[i] = i % 3 == 2 ? kInf : 0.2;
      if (i == 0) bounds.lower[i] = bounds.upper[i] = 0.3;
      if (i % 2 == 1) bounds.penalty[i] = 0.5;
    }
    VectorXd x, y;
    const InteriorPointResult result = dense.solve(x, y);
    EXPECT_TRUE(result.solved) << "seed " << seed;
    expect_optimal(dense, x, y, 1e-7);
    // Warm: from its own multipliers it comes to the same place.
    VectorXd again;
    VectorXd multipliers = y;
    const InteriorPointResult warm = dense.solve(again, multipliers, 1e-6);
    EXPECT_TRUE(warm.solved);
    EXPECT_LE((again - x).lpNorm<Eigen::Infinity>(), 1e-5);
  }
}

TEST(InteriorPoint, GivesWayWhereRowsContradictEachOther) {
  MatrixXd rows(2, 1);
  rows << 1.0, 1.0;
  DenseProgram dense(MatrixXd::Constant(1, 1, 0.1), MatrixXd::Zero(1, 1), rows);
  dense.program.bounds.lower << 1.0, -kInf;  // x >= 1 and x <= 0, the first at the higher price
  dense.program.bounds.upper << kInf, 0.0;
  dense.program.bounds.penalty << 10.0, 2.0;
  VectorXd x, y;
  EXPECT_TRUE(dense.solve(x, y).solved);
  EXPECT_NEAR(x[0], 1.0, 1e-6);
  EXPECT_NEAR(y[1], 2.0, 1e-6);
}

TEST(InteriorPoint, SaysThatHardRowsContradictEachOther) {
  MatrixXd rows(2, 1);
  rows << 1.0, 1.0;
  DenseProgram dense(MatrixXd::Ones(1, 1), MatrixXd::Zero(1, 1), rows);
  dense.program.bounds.lower << 1.0, -kInf;
  dense.program.bounds.upper << kInf, 0.0;
  VectorXd x, y;
  EXPECT_FALSE(dense.solve(x, y).solved);
}

TEST(InteriorPoint, KeepsEquationsWhereEverythingIsPinned) {
  // Curvature so large beside the typical one that multipliers have far to go: the proximal method alone
  // would bring them nearer by a thousandth at a time.
  std::srand(11);
  constexpr Index n = 8, m = 4;
  const MatrixXd stiff = VectorXd::LinSpaced(n, 2e4, 4e4).asDiagonal();
  DenseProgram dense(stiff, MatrixXd::Zero(n, n), MatrixXd::Random(m, n));
  dense.program.scale = 1e-3;
  dense.program.bounds.lower = dense.program.bounds.upper = VectorXd::LinSpaced(m, -1e-6, 1e-6);
  VectorXd x, y;
  const InteriorPointResult result = dense.solve(x, y);
  EXPECT_TRUE(result.solved);
  EXPECT_LE(result.iterations, 3);
  // By elimination: x = H^-1 G^T (G H^-1 G^T)^-1 b.
  const MatrixXd by_H = dense.H().inverse() * dense.G_full.transpose();
  const VectorXd expected = by_H * (dense.G_full * by_H).lu().solve(dense.program.bounds.lower);
  EXPECT_LE((x - expected).lpNorm<Eigen::Infinity>(), 1e-9);
}

TEST(NormalMatrix, IsTheSumOfItsProducts) {
  std::srand(7);
  BlockRows a, b;
  a.add(2, {0, 2, 3});
  a.add_diagonal({1, 3});
  b.add(3, {1, 2});
  CurvatureBlocks C;
  C.add({0, 3});
  const auto random = [](auto begin, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) begin[i] = Eigen::internal::random<double>(-1.0, 1.0);
  };
  random(a.values(a.block(0)), 6);
  random(a.values(a.block(1)), 2);
  random(b.values(b.block(0)), 6);
  C.values(0) << 1.0, 0.4, 0.4, 2.0;
  NormalMatrix normal(4, C, {&a, &b});
  const VectorXd diagonal = VectorXd::LinSpaced(4, 1.0, 2.0);
  const VectorXd weights = VectorXd::LinSpaced(3, 0.5, 1.5);
  const VectorXd ones;
  normal.assemble(diagonal, {&ones, &weights});

  // Column by column from the products with unit vectors.
  MatrixXd expected = diagonal.asDiagonal();
  for (int j = 0; j < 4; ++j) {
    const VectorXd unit = VectorXd::Unit(4, j);
    VectorXd column = VectorXd::Zero(4), rows;
    a.multiply(unit, rows);
    a.add_transposed(rows, column);
    b.multiply(unit, rows);
    b.add_transposed(weights.cwiseProduct(rows), column);
    C.add_product(unit, column);
    expected.col(j) += column;
  }
  const SymmetricMatrix& K = normal.matrix();
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i <= j; ++i) {
      double found = 0.0;
      for (int e = K.column_starts[static_cast<std::size_t>(j)];
           e < K.column_starts[static_cast<std::size_t>(j) + 1]; ++e) {
        if (K.rows[static_cast<std::size_t>(e)] == i) found = K.values[static_cast<std::size_t>(e)];
      }
      EXPECT_NEAR(found, expected(i, j), 1e-15) << i << " " << j;
    }
  }
  DenseCholesky cholesky;
  ASSERT_TRUE(cholesky.factorize(K));
  VectorXd x = VectorXd::LinSpaced(4, -1.0, 1.0);
  cholesky.solve(x);
  EXPECT_LE((expected.selfadjointView<Eigen::Lower>() * x - VectorXd::LinSpaced(4, -1.0, 1.0)).norm(), 1e-14);
}

TEST(DenseCholesky, SaysThatAMatrixIsNotPositiveDefinite) {
  SymmetricMatrix K;
  K.size = 2;
  K.column_starts = {0, 1, 3};
  K.rows = {0, 0, 1};
  K.values = {1.0, 2.0, 1.0};
  DenseCholesky cholesky;
  EXPECT_FALSE(cholesky.factorize(K));
  K.values = {1.0, 0.5, 1.0};
  EXPECT_TRUE(cholesky.factorize(K));
}

}  // namespace interior_point_test
}  // namespace armtune::internal
