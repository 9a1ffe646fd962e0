#pragma once
// QR factorisation of tall sparse matrices by SuiteSparse SPQR, whose types are used only in sparse_qr.cpp.
// Source: Davis, Algorithm 915, SuiteSparseQR: multifrontal multithreaded rank-revealing sparse QR
// factorization, 2011.

#include <Eigen/SparseCore>
#include <vector>

namespace armtune::internal {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, long>;

/// Returns the upper triangular R (n x n, dense) with R^T R = A^T A, without pivoting. A: m x n, any m.
Eigen::MatrixXd triangular_factor(const SparseMatrix& A);

/// The columns of A that are independent of those before them, and the columns that are not.
struct RankRevealed {
  std::vector<int> live;  ///< independent columns, in order
  std::vector<int> dead;  ///< in order; each depends on the live ones before it
  Eigen::MatrixXd R;      ///< rank x n: columns `live` (upper triangular), then `dead`
};

/// Computes a rank-revealing factorisation that examines the columns in their order. A column is dead if the
/// part of it that is orthogonal to the live columns before it is shorter than `tolerance` (Heath's rule).
RankRevealed rank_revealing_factor(const SparseMatrix& A, double tolerance);

}  // namespace armtune::internal
