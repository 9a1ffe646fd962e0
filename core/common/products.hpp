#pragma once
// Small matrix and vector products for the computations of every control period. They add their terms in the
// same order, first to last, for every scalar type. With Eigen's own products, the order and therefore the
// last bit of the result depend on scalar type and size.

#include <cmath>

#include "core/common/types.hpp"

namespace armtune::internal {

/// Returns R v.
template <typename T>
[[gnu::always_inline]] inline Vec3T<T> times(const Mat3T<T>& R, const Vec3T<T>& v) {
  return R.col(0) * v[0] + R.col(1) * v[1] + R.col(2) * v[2];
}

/// Returns a . b of 3-vectors.
template <typename A, typename B>
auto dot3(const A& a, const B& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Returns R^T v.
template <typename T>
Vec3T<T> transposed_times(const Mat3T<T>& R, const Vec3T<T>& v) {
  return {dot3(R.col(0), v), dot3(R.col(1), v), dot3(R.col(2), v)};
}

/// Returns A B.
template <typename T>
Mat3T<T> times(const Mat3T<T>& A, const Mat3T<T>& B) {
  Mat3T<T> C;
  for (int j = 0; j < 3; ++j) C.col(j) = A.col(0) * B(0, j) + A.col(1) * B(1, j) + A.col(2) * B(2, j);
  return C;
}

/// Returns J x for a 6 x n Jacobian.
template <typename T>
Vec6T<T> times(const JacobianT<T>& J, const JointVectorT<T>& x) {
  Vec6T<T> y = J.col(0) * x[0];
  for (Eigen::Index i = 1; i < J.cols(); ++i) y += J.col(i) * x[i];
  return y;
}

/// Computes x = J^T y (n).
template <typename T>
void transposed_times(const JacobianT<T>& J, const Vec6T<T>& y, JointVectorT<T>& x) {
  x.resize(J.cols());
  for (Eigen::Index i = 0; i < J.cols(); ++i) {
    T sum = J(0, i) * y[0];
    for (int row = 1; row < 6; ++row) sum += J(row, i) * y[row];
    x[i] = sum;
  }
}

/// Returns |x|.
template <typename T>
T norm(const JointVectorT<T>& x) {
  using std::sqrt;
  T sum = x[0] * x[0];
  for (Eigen::Index i = 1; i < x.size(); ++i) sum += x[i] * x[i];
  return sqrt(sum);
}

}  // namespace armtune::internal
