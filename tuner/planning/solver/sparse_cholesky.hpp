#pragma once
// Factorises a sparse symmetric positive definite matrix (Cholesky) with the library SuiteSparse CHOLMOD,
// whose types are used only in sparse_cholesky.cpp. Source: Chen, Davis, Hager, Rajamanickam, Algorithm 887:
// CHOLMOD, 2008.

#include "tuner/quadratic/cholesky.hpp"

namespace armtune::internal {

/// A factorisation that is analysed once for a pattern, then computed for any number of values.
class SparseCholesky final : public Cholesky {
 public:
  /// Analyses the pattern; the columns keep their order. Throws FailedError if memory runs out.
  explicit SparseCholesky(const SymmetricMatrix& pattern);
  ~SparseCholesky() override;
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  bool factorize(const SymmetricMatrix& matrix) override;
  void solve(Eigen::VectorXd& x) override;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

/// Makes a SparseCholesky, for InteriorPoint.
std::unique_ptr<Cholesky> make_sparse_cholesky(const SymmetricMatrix& pattern);

}  // namespace armtune::internal
