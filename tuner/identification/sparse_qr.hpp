#pragma once
// QR factorisation of tall sparse matrices by SuiteSparse SPQR, whose types stay in sparse_qr.cpp.
// Davis, Algorithm 915, SuiteSparseQR: multifrontal multithreaded rank-revealing sparse QR factorization,
// 2011.

#include <Eigen/SparseCore>
#include <vector>

namespace armtune::internal {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, long>;

/// Upper triangular R (n x n, dense) with R^T R = A^T A, columns in their order; A: m x n, any m.
Eigen::MatrixXd triangular_factor(const SparseMatrix& A);

/// Which columns of A are independent of those before them.
struct RankRevealed {
  std::vector<int> live;  ///< in order
  std::vector<int> dead;  ///< in order; each depends on the live ones before it
  Eigen::MatrixXd R;      ///< rank x n: columns `live` (upper triangular), then `dead`
};

/// Rank-revealing factorisation with columns in their order: a column is dead when less than `tolerance` of
/// it is left beside the live ones before it (Heath's rule).
RankRevealed rank_revealing_factor(const SparseMatrix& A, double tolerance);

}  // namespace armtune::internal
