#pragma once
// The condensed matrix of an interior point step: K = diag + curvature + sum of J^T D J over block rows. Its
// pattern is found once; each assembly adds small dense products to places that are known.

#include "tuner/planning/solver/block_rows.hpp"
#include "tuner/planning/solver/curvature_blocks.hpp"
#include "tuner/planning/solver/sparse_cholesky.hpp"

namespace armtune::internal {

class NormalMatrix {
 public:
  /// Lays out K (size x size) for products of these rows, each of which must outlive it.
  NormalMatrix(int size, const CurvatureBlocks& curvature, const std::vector<const BlockRows*>& parts);

  const SymmetricMatrix& matrix() const { return matrix_; }

  /// K = diag(diagonal) + curvature + sum over parts p of J_p^T diag(weights_p) J_p; an empty weight vector
  /// stands for ones.
  void assemble(const Eigen::VectorXd& diagonal, const std::vector<const Eigen::VectorXd*>& weights);

 private:
  /// Calls visit(columns, count) for every block that is not diagonal, in the order of `places_`.
  template <typename Visit>
  void for_dense_blocks(const Visit& visit) const;

  const CurvatureBlocks& curvature_;
  std::vector<const BlockRows*> parts_;
  SymmetricMatrix matrix_;
  /// Of the curvature, then part by part, block by block: the places in K of the block's pairs of columns (j
  /// <= i, column i by column i).
  std::vector<int> places_;
  std::vector<int> diagonal_places_;
  std::vector<double> product_;  ///< one column of a block's
};

}  // namespace armtune::internal
