#include "tuner/quadratic/condensed_system.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <cstdlib>

#include "tests/tuner/support/dense_program.hpp"

namespace armtune::internal {
namespace condensed_system_test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::DenseProgram;

/// A program's system, and the same as one dense matrix.
struct Systems {
  explicit Systems(const DenseProgram& program)
      : dense(program),
        normal(static_cast<int>(program.G_full.cols()), program.C, {&program.R, &program.G}),
        condensed(program.program, normal, cholesky) {}

  /// [H + delta, G^T; G, -yield]
  MatrixXd whole(const VectorXd& yield) const {
    const Index n = dense.G_full.cols(), m = dense.G_full.rows();
    MatrixXd whole(n + m, n + m);
    whole << dense.H() + condensed.delta() * MatrixXd::Identity(n, n), dense.G_full.transpose(), dense.G_full,
        -MatrixXd(yield.asDiagonal());
    return whole;
  }

  const DenseProgram& dense;
  NormalMatrix normal;
  DenseCholesky cholesky;
  CondensedSystem condensed;
};

VectorXd stacked(const VectorXd& x, const VectorXd& y) {
  VectorXd both(x.size() + y.size());
  both << x, y;
  return both;
}

TEST(CondensedSystem, SolvesBothRowsOfTheLinearSystemWhateverTheRowsYield) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::srand(seed);
    const Index n = 4 + seed % 5;
    const Index m = 1 + seed % 4;
    const MatrixXd root = MatrixXd::Random(n, n);
    DenseProgram dense(MatrixXd::Random(n + 1, n), root * root.transpose(), MatrixXd::Random(m, n));
    dense.program.damping = VectorXd::LinSpaced(n, 0.1, 0.3);
    Systems systems(dense);
    // From rows that are equations to rows that are hardly there.
    VectorXd yield(m);
    for (Index i = 0; i < m; ++i) yield[i] = i == 0 ? 0.0 : std::pow(10.0, static_cast<double>(3 * i - 6));
    ASSERT_TRUE(systems.condensed.factorize(yield));
    const VectorXd rd = VectorXd::Random(n);
    const VectorXd e = VectorXd::Random(m);
    LinearUnknowns found;
    systems.condensed.solve(rd, e, {1e-12, 1e-12}, found);
    const MatrixXd whole = systems.whole(yield);
    // Rounding of rows of size 1, from multipliers of up to 1e3.
    EXPECT_LE((whole * stacked(found.x, found.y) - stacked(rd, e)).lpNorm<Eigen::Infinity>(), 1e-11) << seed;
    const VectorXd expected = whole.fullPivLu().solve(stacked(rd, e));
    EXPECT_LE((stacked(found.x, found.y) - expected).norm(), 1e-9 * expected.norm()) << seed;
  }
}

/// So stiff that the dual proximal part, 1e-6, is far larger than G H^-1 G^T.
struct Stiff : DenseProgram {
  Stiff() : DenseProgram(VectorXd::LinSpaced(8, 4e3, 8e3).asDiagonal(), MatrixXd::Zero(8, 8), four_rows()) {
    program.scale = 1e-6;
  }
  static MatrixXd four_rows() {
    std::srand(11);
    return MatrixXd::Random(4, 8);
  }
};

TEST(CondensedSystem, TheProximalSolveLetsEveryRowGiveWayByTheSamePartMore) {
  const Stiff stiff;
  Systems systems(stiff);
  const VectorXd yield = VectorXd::LinSpaced(4, 0.0, 1e-3);
  ASSERT_TRUE(systems.condensed.factorize(yield));
  const VectorXd rd = VectorXd::LinSpaced(8, -1.0, 2.0);
  const VectorXd e = VectorXd::LinSpaced(4, 1.0, 0.5);
  LinearUnknowns found = {rd, {}};
  systems.condensed.solve_proximal(e, found);
  const VectorXd left = stacked(rd, e) - systems.whole(yield) * stacked(found.x, found.y);
  EXPECT_LE(left.head(8).lpNorm<Eigen::Infinity>(), 1e-9);
  const double more = -left[8] / found.y[0];
  EXPECT_GT(more, 0.0);
  for (Index i = 0; i < 4; ++i) EXPECT_NEAR(-left[8 + i] / found.y[i], more, 1e-9 * more);
}

TEST(CondensedSystem, RowsAreExactWhereTheProximalPartIsFarLargerThanWhatTheyMove) {
  const Stiff stiff;
  Systems systems(stiff);
  const VectorXd yield = VectorXd::Zero(4);
  ASSERT_TRUE(systems.condensed.factorize(yield));
  const VectorXd rd = VectorXd::Zero(8);
  const VectorXd e = VectorXd::LinSpaced(4, 1.0, 0.5);
  LinearUnknowns found = {rd, {}};
  systems.condensed.solve_proximal(e, found);
  EXPECT_GE((stiff.G_full * found.x - e).lpNorm<Eigen::Infinity>(), 0.5) << "or this test says nothing";
  systems.condensed.solve(rd, e, {1e-9, 1e-9}, found);
  EXPECT_LE((stiff.G_full * found.x - e).lpNorm<Eigen::Infinity>(), 1e-9);
}

TEST(CondensedSystem, AddsAsMuchCurvatureAsItNeedsWithinReason) {
  const auto with_curvature = [](double curvature) { return MatrixXd(curvature * MatrixXd::Identity(2, 2)); };
  const VectorXd yield = VectorXd::Ones(1);
  const DenseProgram convex(MatrixXd::Zero(1, 2), with_curvature(1.0), MatrixXd::Zero(1, 2));
  Systems easy(convex);
  ASSERT_TRUE(easy.condensed.factorize(yield));
  // As much below zero as rounding may be, and as no rounding is.
  const DenseProgram rounded(MatrixXd::Zero(1, 2), with_curvature(-10.0 * easy.condensed.delta()),
                             MatrixXd::Zero(1, 2));
  Systems harder(rounded);
  ASSERT_TRUE(harder.condensed.factorize(yield));
  EXPECT_GT(harder.condensed.delta(), 10.0 * easy.condensed.delta());
  const DenseProgram concave(MatrixXd::Zero(1, 2), with_curvature(-1.0), MatrixXd::Zero(1, 2));
  EXPECT_FALSE(Systems(concave).condensed.factorize(yield));
}

}  // namespace condensed_system_test
}  // namespace armtune::internal
