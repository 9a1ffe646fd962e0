#pragma once
// Cholesky factorisation A = L L^T of a symmetric matrix of at most six rows. The scalar type T is double for
// one matrix, or a SIMD type for several matrices at once (pack.hpp). Source: Golub and Van Loan, Matrix
// Computations, section 4.2.

#include <cmath>

#include "core/common/select.hpp"
#include "core/common/types.hpp"

namespace armtune::internal {

template <typename T>
class Cholesky6T {
 public:
  using Matrix = Eigen::Matrix<T, 6, 6>;

  /// Factorises the leading n rows and columns of A. Only their lower triangle is read.
  void compute(const Matrix& A, int n) {
    using std::sqrt;
    n_ = n;
    product_ = T(1);
    for (int j = 0; j < n; ++j) {
      T square = A(j, j);
      for (int k = 0; k < j; ++k) square -= L_(j, k) * L_(j, k);
      // If a square is not positive, A is not positive definite. The product is then zero and stays zero.
      const T root = sqrt(square);
      product_ = select(square > T(0), product_ * root, T(0));
      L_(j, j) = root;
      inverse_[j] = T(1) / root;
      for (int i = j + 1; i < n; ++i) {
        T sum = A(i, j);
        for (int k = 0; k < j; ++k) sum -= L_(i, k) * L_(j, k);
        L_(i, j) = sum * inverse_[j];
      }
    }
  }

  /// Returns sqrt(det A), the product of L's diagonal; zero if A is not positive definite.
  const T& root_of_determinant() const { return product_; }

  /// Returns A^-1 b in the leading n entries; the entries of b beyond them are returned unchanged.
  Vec6T<T> solve(const Vec6T<T>& b) const {
    Vec6T<T> x = b;
    for (int i = 0; i < n_; ++i) {
      for (int k = 0; k < i; ++k) x[i] -= L_(i, k) * x[k];
      x[i] *= inverse_[i];
    }
    for (int i = n_ - 1; i >= 0; --i) {
      for (int k = i + 1; k < n_; ++k) x[i] -= L_(k, i) * x[k];
      x[i] *= inverse_[i];
    }
    return x;
  }

 private:
  int n_ = 0;
  Matrix L_;
  Vec6T<T> inverse_;  ///< 1 divided by each entry of the diagonal of L
  T product_;
};

}  // namespace armtune::internal
