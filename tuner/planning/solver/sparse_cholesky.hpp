#pragma once
// Cholesky factorisation of a sparse symmetric positive definite matrix by SuiteSparse CHOLMOD, whose types
// stay in sparse_cholesky.cpp. Chen, Davis, Hager, Rajamanickam, Algorithm 887: CHOLMOD, 2008.

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace armtune::internal {

/// Upper triangle of a symmetric matrix, compressed by columns, rows ascending: what CHOLMOD factorises
/// without transposing. The pattern stays as it is made.
struct SymmetricMatrix {
  int size = 0;
  std::vector<int> column_starts;  ///< size + 1
  std::vector<int> rows;
  std::vector<double> values;
};

/// Analysed once for a pattern, then factorised for as many values as wanted.
class SparseCholesky {
 public:
  /// Analyses the pattern; the columns keep their order. Throws FailedError if memory runs out.
  explicit SparseCholesky(const SymmetricMatrix& pattern);
  ~SparseCholesky();
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  /// L L^T = matrix, which has the pattern analysed. False if it is not positive definite.
  bool factorize(const SymmetricMatrix& matrix);
  /// Solves L L^T x = x in place.
  void solve(Eigen::VectorXd& x);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace armtune::internal
