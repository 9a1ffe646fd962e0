#pragma once
// Vectors and matrices whose entries are pairs of numbers, called twins (common/twin.hpp). With them the
// dynamics compute two 3-vectors at once, such as force and moment, or two symmetric matrices.

#include "core/common/products.hpp"
#include "core/common/twin.hpp"
#include "core/common/types.hpp"

namespace armtune::internal {

/// Two 3-vectors side by side.
template <typename T>
struct TwinVec3T {
  Twin<T> x, y, z;

  TwinVec3T() = default;
  TwinVec3T(const Twin<T>& x_, const Twin<T>& y_, const Twin<T>& z_) : x(x_), y(y_), z(z_) {}
  TwinVec3T(const Vec3T<T>& first, const Vec3T<T>& second)
      : x(first.x(), second.x()), y(first.y(), second.y()), z(first.z(), second.z()) {}
  static TwinVec3T zero() { return both(Vec3T<T>::Zero()); }
  static TwinVec3T both(const Vec3T<T>& v) { return {v, v}; }

  Vec3T<T> first() const { return {x.first(), y.first(), z.first()}; }
  Vec3T<T> second() const { return {x.second(), y.second(), z.second()}; }

  friend TwinVec3T operator+(const TwinVec3T& a, const TwinVec3T& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend TwinVec3T operator*(const Twin<T>& s, const TwinVec3T& v) { return {s * v.x, s * v.y, s * v.z}; }
  TwinVec3T& operator+=(const TwinVec3T& b) { return *this = *this + b; }
  /// Adds to the first vector, or to the second.
  void add_first(const Vec3T<T>& v) {
    x.add_first(v[0]);
    y.add_first(v[1]);
    z.add_first(v[2]);
  }
  void add_second(const Vec3T<T>& v) {
    x.add_second(v[0]);
    y.add_second(v[1]);
    z.add_second(v[2]);
  }

  TwinVec3T cross(const TwinVec3T& b) const {
    return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x};
  }
  /// Returns both dot products.
  Twin<T> dot(const TwinVec3T& b) const { return x * b.x + y * b.y + z * b.z; }
  /// Returns v x z of both vectors v, where z is the unit vector along z.
  TwinVec3T cross_axis() const { return {y, -x, Twin<T>::both(T(0))}; }
};

/// Two symmetric 3 x 3 matrices side by side, by their six entries.
template <typename T>
struct TwinSymmetric3T {
  Twin<T> xx, xy, xz, yy, yz, zz;

  TwinVec3T<T> operator*(const TwinVec3T<T>& v) const {
    return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z, xz * v.x + yz * v.y + zz * v.z};
  }
  /// Returns the product of v and the first matrix, or the second.
  Vec3T<T> first_times(const Vec3T<T>& v) const {
    return {xx.first() * v[0] + xy.first() * v[1] + xz.first() * v[2],
            xy.first() * v[0] + yy.first() * v[1] + yz.first() * v[2],
            xz.first() * v[0] + yz.first() * v[1] + zz.first() * v[2]};
  }
  Vec3T<T> second_times(const Vec3T<T>& v) const {
    return {xx.second() * v[0] + xy.second() * v[1] + xz.second() * v[2],
            xy.second() * v[0] + yy.second() * v[1] + yz.second() * v[2],
            xz.second() * v[0] + yz.second() * v[1] + zz.second() * v[2]};
  }
  void operator+=(const TwinSymmetric3T& b) {
    xx += b.xx;
    xy += b.xy;
    xz += b.xz;
    yy += b.yy;
    yz += b.yz;
    zz += b.zz;
  }
  /// Subtracts s v^T, where s is a multiple of v.
  void subtract_square(const TwinVec3T<T>& s, const TwinVec3T<T>& v) {
    xx -= s.x * v.x;
    xy -= s.x * v.y;
    xz -= s.x * v.z;
    yy -= s.y * v.y;
    yz -= s.y * v.z;
    zz -= s.z * v.z;
  }
};

/// Returns R v of both vectors.
template <typename T>
[[gnu::always_inline]] inline TwinVec3T<T> times(const Mat3T<T>& R, const TwinVec3T<T>& v) {
  return {v.x * R(0, 0) + v.y * R(0, 1) + v.z * R(0, 2), v.x * R(1, 0) + v.y * R(1, 1) + v.z * R(1, 2),
          v.x * R(2, 0) + v.y * R(2, 1) + v.z * R(2, 2)};
}
/// Returns R^T v of both vectors.
template <typename T>
[[gnu::always_inline]] inline TwinVec3T<T> transposed_times(const Mat3T<T>& R, const TwinVec3T<T>& v) {
  return {v.x * R(0, 0) + v.y * R(1, 0) + v.z * R(2, 0), v.x * R(0, 1) + v.y * R(1, 1) + v.z * R(2, 1),
          v.x * R(0, 2) + v.y * R(1, 2) + v.z * R(2, 2)};
}

/// One 3 x 3 matrix, stored by columns. The upper two entries of each column form a twin.
template <typename T>
struct SplitMat3T {
  Twin<T> top[3];
  T bottom[3];

  static SplitMat3T zero() {
    const Twin<T> none = Twin<T>::both(T(0));
    return {{none, none, none}, {T(0), T(0), T(0)}};
  }
  /// Returns entry (i, j).
  T operator()(int i, int j) const { return i == 0 ? top[j].first() : i == 1 ? top[j].second() : bottom[j]; }
  Vec3T<T> operator*(const Vec3T<T>& v) const {
    const Twin<T> upper = top[0] * v[0] + top[1] * v[1] + top[2] * v[2];
    return {upper.first(), upper.second(), bottom[0] * v[0] + bottom[1] * v[1] + bottom[2] * v[2]};
  }
  /// Returns the transposed matrix times v.
  Vec3T<T> transposed_times(const Vec3T<T>& v) const {
    return {dot3(column(0), v), dot3(column(1), v), dot3(column(2), v)};
  }
  /// Subtracts a b^T.
  void subtract_product(const Vec3T<T>& a, const Vec3T<T>& b) {
    const Twin<T> upper(a[0], a[1]);
    for (int j = 0; j < 3; ++j) {
      top[j] -= upper * b[j];
      bottom[j] -= a[2] * b[j];
    }
  }

 private:
  Vec3T<T> column(int j) const { return {top[j].first(), top[j].second(), bottom[j]}; }
};

}  // namespace armtune::internal
