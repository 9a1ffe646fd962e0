#pragma once
// Factorises a sparse symmetric positive definite matrix (Cholesky) with the library SuiteSparse CHOLMOD,
// whose types are used only in sparse_cholesky.cpp. Source: Chen, Davis, Hager, Rajamanickam, Algorithm 887:
// CHOLMOD, 2008.

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace armtune::internal {

/// The upper triangle of a symmetric matrix in compressed columns, with ascending rows in each column.
/// CHOLMOD factorises this form without transposing. The pattern does not change after it is made.
struct SymmetricMatrix {
  int size = 0;
  std::vector<int> column_starts;  ///< size + 1
  std::vector<int> rows;
  std::vector<double> values;
};

/// A factorisation that is analysed once for a pattern, then computed for any number of values.
class SparseCholesky {
 public:
  /// Analyses the pattern; the columns keep their order. Throws FailedError if memory runs out.
  explicit SparseCholesky(const SymmetricMatrix& pattern);
  ~SparseCholesky();
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  /// Computes L with L L^T = matrix. The matrix must have the analysed pattern. Returns false if it is not
  /// positive definite.
  bool factorize(const SymmetricMatrix& matrix);
  /// Solves L L^T x = x in place.
  void solve(Eigen::VectorXd& x);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace armtune::internal
