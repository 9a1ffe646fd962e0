#pragma once
// A symmetric 3 x 3 matrix by its six numbers: half the work of a full one in the inertia recursions.

#include "core/common/types.hpp"

namespace armtune {

template <typename T>
struct Symmetric3T {
  T xx, xy, xz, yy, yz, zz;

  /// Of a full matrix that is symmetric: its upper half is read.
  static Symmetric3T of(const Mat3T<T>& S) { return {S(0, 0), S(0, 1), S(0, 2), S(1, 1), S(1, 2), S(2, 2)}; }

  Vec3T<T> z_column() const { return {xz, yz, zz}; }

  Vec3T<T> operator*(const Vec3T<T>& v) const {
    return {xx * v[0] + xy * v[1] + xz * v[2], xy * v[0] + yy * v[1] + yz * v[2],
            xz * v[0] + yz * v[1] + zz * v[2]};
  }
  void operator+=(const Symmetric3T& other) {
    xx += other.xx;
    xy += other.xy;
    xz += other.xz;
    yy += other.yy;
    yz += other.yz;
    zz += other.zz;
  }
  void add_diagonal(const T& value) {
    xx += value;
    yy += value;
    zz += value;
  }
  /// Takes scale * v v^T away.
  void subtract_square(const T& scale, const Vec3T<T>& v) {
    const Vec3T<T> s = scale * v;
    xx -= s[0] * v[0];
    xy -= s[0] * v[1];
    xz -= s[0] * v[2];
    yy -= s[1] * v[1];
    yz -= s[1] * v[2];
    zz -= s[2] * v[2];
  }
};

/// R S R^T.
template <typename T>
Symmetric3T<T> rotated(const Mat3T<T>& R, const Symmetric3T<T>& S) {
  const Vec3T<T> a = S * Vec3T<T>(R(0, 0), R(0, 1), R(0, 2));
  const Vec3T<T> b = S * Vec3T<T>(R(1, 0), R(1, 1), R(1, 2));
  const Vec3T<T> c = S * Vec3T<T>(R(2, 0), R(2, 1), R(2, 2));
  const auto row_times = [&R](int i, const Vec3T<T>& v) {
    return R(i, 0) * v[0] + R(i, 1) * v[1] + R(i, 2) * v[2];
  };
  return {row_times(0, a), row_times(0, b), row_times(0, c),
          row_times(1, b), row_times(1, c), row_times(2, c)};
}

}  // namespace armtune
