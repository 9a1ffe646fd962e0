#pragma once
// Assembles the matrix K of the linear system that each interior point step solves. K is the sum of a
// diagonal matrix, the matrix of second derivatives (curvature), and J^T D J for every Jacobian J, with
// diagonal weights D. The sparsity pattern of K is found once. Each assembly then adds small dense products
// at known places.

#include "tuner/quadratic/block_rows.hpp"
#include "tuner/quadratic/cholesky.hpp"
#include "tuner/quadratic/curvature_blocks.hpp"

namespace armtune::internal {

class NormalMatrix {
 public:
  /// Finds the pattern of K (size x size). parts: the Jacobians J. The curvature and each of the parts must
  /// outlive this object.
  NormalMatrix(int size, const CurvatureBlocks& curvature, const std::vector<const BlockRows*>& parts);

  const SymmetricMatrix& matrix() const { return matrix_; }

  /// Computes K = diag(diagonal) + curvature + sum over parts p of J_p^T diag(weights_p) J_p. An empty weight
  /// vector stands for ones.
  void assemble(const Eigen::VectorXd& diagonal, const std::vector<const Eigen::VectorXd*>& weights);

 private:
  /// Calls visit(columns, count) for every dense block, that is, every block that is not itself a diagonal
  /// matrix, in the order of `places_`.
  template <typename Visit>
  void for_dense_blocks(const Visit& visit) const;

  const CurvatureBlocks& curvature_;
  std::vector<const BlockRows*> parts_;
  SymmetricMatrix matrix_;
  /// The places in K for the entries (j, i), j <= i, of every block, column by column. The blocks of the
  /// curvature come first, then the blocks of each part in turn.
  std::vector<int> places_;
  std::vector<int> diagonal_places_;
  std::vector<double> product_;  ///< one column of a block's product
};

}  // namespace armtune::internal
