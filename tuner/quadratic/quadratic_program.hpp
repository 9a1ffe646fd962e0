#pragma once
// Defines a quadratic program whose constraint rows may be elastic, that is, violated at a penalty:
//   minimise    |R x|^2 / 2 + x^T C x / 2 + sum_i damping_i * x_i^2 / 2 + gradient^T x
//               + sum_i penalty_i * v_i
//   subject to  lower_i - v_i <= G_i x <= upper_i + v_i,   v_i >= 0.
// v_i is the violation of row i. It is 0 for hard rows, whose penalty is infinite.

#include "tuner/quadratic/block_rows.hpp"
#include "tuner/quadratic/curvature_blocks.hpp"

namespace armtune::internal {

struct RowBounds {
  Eigen::VectorXd lower;    ///< -inf: none; equal to upper: an equation
  Eigen::VectorXd upper;    ///< +inf: none
  Eigen::VectorXd penalty;  ///< l1 weight of a violation; inf: the row is hard
};

struct QuadraticProgram {
  const BlockRows* residuals = nullptr;        ///< R
  const CurvatureBlocks* curvature = nullptr;  ///< C
  const BlockRows* rows = nullptr;             ///< G
  RowBounds bounds;
  Eigen::VectorXd gradient;
  Eigen::VectorXd damping;  ///< >= 0
  double scale = 1.0;       ///< typical curvature; scales the primal proximal part (condensed_system.hpp)
};

}  // namespace armtune::internal
