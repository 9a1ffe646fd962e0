#pragma once
// LU factorisation of a 6 x 6 matrix with partial pivoting. The scalar type T is double for one matrix, or a
// SIMD type for several matrices at once; each matrix then swaps its own rows (pack.hpp). Source: Golub and
// Van Loan, Matrix Computations, section 3.4.

#include <array>
#include <utility>

#include "core/common/select.hpp"
#include "core/common/types.hpp"

namespace armtune::internal {

template <typename T>
class Lu6T {
 public:
  void compute(const JacobianT<T>& A) {
    using std::abs;
    rows_ = A;
    std::size_t pair = 0;
    for (int k = 0; k < 6; ++k) {
      for (int r = k + 1; r < 6; ++r, ++pair) {
        const MaskT<T> larger = abs(rows_(r, k)) > abs(rows_(k, k));
        swapped_[pair] = larger;
        if (!any(larger)) continue;
        for (int j = 0; j < 6; ++j) exchange(larger, rows_(k, j), rows_(r, j));
      }
      // A pivot of zero has only zeros below it: they need no elimination, and the determinant is zero.
      inverse_pivot_[static_cast<std::size_t>(k)] = select(abs(rows_(k, k)) > T(0), T(1) / rows_(k, k), T(0));
      for (int r = k + 1; r < 6; ++r) {
        const T l = rows_(r, k) * inverse_pivot_[static_cast<std::size_t>(k)];
        rows_(r, k) = l;
        for (int j = k + 1; j < 6; ++j) rows_(r, j) -= l * rows_(k, j);
      }
    }
  }

  T absolute_determinant() const {
    using std::abs;
    T product = rows_(0, 0);
    for (int k = 1; k < 6; ++k) product *= rows_(k, k);
    return abs(product);
  }

  /// Computes x = A^-1 b. The result has no meaning if the determinant is zero.
  void solve(const Vec6T<T>& b, JointVectorT<T>& x) const {
    x = b;
    std::size_t pair = 0;
    for (int k = 0; k < 6; ++k) {
      for (int r = k + 1; r < 6; ++r, ++pair) exchange(swapped_[pair], x[k], x[r]);
    }
    for (int k = 0; k < 6; ++k) {
      for (int r = k + 1; r < 6; ++r) x[r] -= rows_(r, k) * x[k];
    }
    for (int k = 5; k >= 0; --k) {
      x[k] *= inverse_pivot_[static_cast<std::size_t>(k)];
      for (int r = 0; r < k; ++r) x[r] -= rows_(r, k) * x[k];
    }
  }

 private:
  using Rows = Eigen::Matrix<T, 6, 6, Eigen::RowMajor>;
  static void exchange(const MaskT<T>& where, T& a, T& b) {
    const T old = a;
    a = select(where, b, a);
    b = select(where, old, b);
  }

  Rows rows_;  ///< L below the diagonal, U on and above it
  std::array<T, 6> inverse_pivot_;
  std::array<MaskT<T>, 15> swapped_;  ///< for each pair of rows k and r > k: true if swapped
};

}  // namespace armtune::internal
