#pragma once
// Quadratic programs small enough to keep their matrices whole.

#include <limits>
#include <vector>

#include "tuner/quadratic/dense_cholesky.hpp"
#include "tuner/quadratic/interior_point.hpp"

namespace armtune::internal::test {

/// A program of dense blocks, kept beside the matrices it was made from.
struct DenseProgram {
  BlockRows R, G;
  CurvatureBlocks C;
  QuadraticProgram program;
  Eigen::MatrixXd R_full, G_full, C_full;

  DenseProgram(const Eigen::MatrixXd& residuals, const Eigen::MatrixXd& curvature,
               const Eigen::MatrixXd& rows)
      : R_full(residuals), G_full(rows), C_full(curvature) {
    const auto n = static_cast<int>(rows.cols());
    std::vector<int> all;
    for (int i = 0; i < n; ++i) all.push_back(i);
    fill(R, residuals, all);
    fill(G, rows, all);
    C.values(C.add(all)) = curvature;
    program.residuals = &R;
    program.rows = &G;
    program.curvature = &C;
    program.gradient = Eigen::VectorXd::Zero(n);
    program.damping = Eigen::VectorXd::Zero(n);
    program.bounds.lower = Eigen::VectorXd::Constant(G.rows(), -std::numeric_limits<double>::infinity());
    program.bounds.upper = Eigen::VectorXd::Constant(G.rows(), std::numeric_limits<double>::infinity());
    program.bounds.penalty = Eigen::VectorXd::Constant(G.rows(), std::numeric_limits<double>::infinity());
  }
  DenseProgram(const DenseProgram&) = delete;
  DenseProgram& operator=(const DenseProgram&) = delete;

  static void fill(BlockRows& rows, const Eigen::MatrixXd& dense, const std::vector<int>& columns) {
    const int block = rows.add(static_cast<int>(dense.rows()), columns);
    for (Eigen::Index i = 0; i < dense.rows(); ++i) {
      for (Eigen::Index j = 0; j < dense.cols(); ++j)
        rows.values(rows.block(block))[i * dense.cols() + j] = dense(i, j);
    }
  }
  Eigen::MatrixXd H() const {
    return R_full.transpose() * R_full + C_full + Eigen::MatrixXd(program.damping.asDiagonal());
  }
  InteriorPointResult solve(Eigen::VectorXd& x, Eigen::VectorXd& y, double start_mu = 1.0) {
    x.setZero(G_full.cols());
    if (y.size() == 0) y.setZero(G_full.rows());
    InteriorPointOptions options;
    options.start_mu = start_mu;
    return InteriorPoint(static_cast<int>(x.size()), R, C, G, make_dense_cholesky)
        .solve(program, options, x, y);
  }
};

}  // namespace armtune::internal::test
