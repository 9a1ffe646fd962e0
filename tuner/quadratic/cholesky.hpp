#pragma once
// Declares the interface of a Cholesky factorisation of a symmetric positive definite matrix. The interior
// point method (interior_point.hpp) needs one for each of its steps. A factorisation with CHOLMOD is for
// sparse matrices (tuner/planning), one with Eigen for small dense ones (dense_cholesky.hpp).

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace armtune::internal {

/// The upper triangle of a symmetric matrix in compressed columns, with ascending rows in each column. The
/// pattern does not change after it is made.
struct SymmetricMatrix {
  int size = 0;
  std::vector<int> column_starts;  ///< size + 1
  std::vector<int> rows;
  std::vector<double> values;
};

class Cholesky {
 public:
  virtual ~Cholesky() = default;

  /// Computes L with L L^T = matrix. The matrix must have the pattern for which the object was made. Returns
  /// false if it is not positive definite.
  virtual bool factorize(const SymmetricMatrix& matrix) = 0;
  /// Solves L L^T x = x in place.
  virtual void solve(Eigen::VectorXd& x) = 0;

 protected:
  Cholesky() = default;
  Cholesky(const Cholesky&) = default;
  Cholesky& operator=(const Cholesky&) = default;
};

/// A function that makes a factorisation for matrices with this pattern.
using MakeCholesky = std::unique_ptr<Cholesky> (*)(const SymmetricMatrix& pattern);

}  // namespace armtune::internal
