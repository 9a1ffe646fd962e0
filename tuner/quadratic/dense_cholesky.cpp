#include "tuner/quadratic/dense_cholesky.hpp"

namespace armtune::internal {

bool DenseCholesky::factorize(const SymmetricMatrix& matrix) {
  whole_.setZero(matrix.size, matrix.size);
  for (int c = 0; c < matrix.size; ++c) {
    const auto column = static_cast<std::size_t>(c);
    for (int k = matrix.column_starts[column]; k < matrix.column_starts[column + 1]; ++k) {
      const auto entry = static_cast<std::size_t>(k);
      whole_(matrix.rows[entry], c) = matrix.values[entry];
    }
  }
  llt_.compute(whole_);
  return llt_.info() == Eigen::Success;
}

void DenseCholesky::solve(Eigen::VectorXd& x) {
  llt_.solveInPlace(x);
}

std::unique_ptr<Cholesky> make_dense_cholesky(const SymmetricMatrix&) {
  return std::make_unique<DenseCholesky>();
}

}  // namespace armtune::internal
