#pragma once
// Vectors and matrices of twins: two vectors that the same rotation turns, two symmetric matrices at once.

#include "core/common/products.hpp"
#include "core/common/twin.hpp"
#include "core/common/types.hpp"

namespace armtune {

/// Two 3-vectors.
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
  /// Adds to the first, or to the second.
  void add_first(const Vec3T<T>& v) { *this += TwinVec3T(v, Vec3T<T>::Zero()); }
  void add_second(const Vec3T<T>& v) { *this += TwinVec3T(Vec3T<T>::Zero(), v); }

  TwinVec3T cross(const TwinVec3T& b) const {
    return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x};
  }
  /// Both dot products.
  Twin<T> dot(const TwinVec3T& b) const { return x * b.x + y * b.y + z * b.z; }
  /// Both cross products with z.
  TwinVec3T cross_axis() const { return {y, -x, Twin<T>::both(T(0))}; }
};

/// Two symmetric 3 x 3 matrices by their six numbers.
template <typename T>
struct TwinSymmetric3T {
  Twin<T> xx, xy, xz, yy, yz, zz;

  TwinVec3T<T> operator*(const TwinVec3T<T>& v) const {
    return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z, xz * v.x + yz * v.y + zz * v.z};
  }
  TwinVec3T<T> z_column() const { return {xz, yz, zz}; }
  void operator+=(const TwinSymmetric3T& b) {
    xx += b.xx;
    xy += b.xy;
    xz += b.xz;
    yy += b.yy;
    yz += b.yz;
    zz += b.zz;
  }
  /// Takes s v^T away, s being a multiple of v.
  void subtract_square(const TwinVec3T<T>& s, const TwinVec3T<T>& v) {
    xx -= s.x * v.x;
    xy -= s.x * v.y;
    xz -= s.x * v.z;
    yy -= s.y * v.y;
    yz -= s.y * v.z;
    zz -= s.z * v.z;
  }
};

/// One rotation for both. Of doubles each entry fills a register twice.
template <typename T>
class TwinRotationT {
 public:
  TwinRotationT() = default;
  explicit TwinRotationT(const Mat3T<T>& R)
      : row_{TwinVec3T<T>::both(R.row(0)), TwinVec3T<T>::both(R.row(1)), TwinVec3T<T>::both(R.row(2))} {}

  TwinVec3T<T> row(int i) const { return row_[i]; }

 private:
  TwinVec3T<T> row_[3];
};

template <typename T>
[[gnu::always_inline]] inline TwinVec3T<T> operator*(const TwinRotationT<T>& R, const TwinVec3T<T>& v) {
  return {R.row(0).dot(v), R.row(1).dot(v), R.row(2).dot(v)};
}
/// R^T v.
template <typename T>
[[gnu::always_inline]] inline TwinVec3T<T> back(const TwinRotationT<T>& R, const TwinVec3T<T>& v) {
  return v.x * R.row(0) + v.y * R.row(1) + v.z * R.row(2);
}
/// R S R^T.
template <typename T>
[[gnu::always_inline]] inline TwinSymmetric3T<T> rotated(const TwinRotationT<T>& R,
                                                         const TwinSymmetric3T<T>& S) {
  const TwinVec3T<T> a = S * R.row(0);
  const TwinVec3T<T> b = S * R.row(1);
  const TwinVec3T<T> c = S * R.row(2);
  return {R.row(0).dot(a), R.row(0).dot(b), R.row(0).dot(c),
          R.row(1).dot(b), R.row(1).dot(c), R.row(2).dot(c)};
}

/// One 3 x 3 matrix by its columns, the upper two rows of each as a twin.
template <typename T>
struct SplitMat3T {
  Twin<T> top[3];
  T bottom[3];

  static SplitMat3T zero() {
    const Twin<T> none = Twin<T>::both(T(0));
    return {{none, none, none}, {T(0), T(0), T(0)}};
  }
  /// Entry (i, j).
  T operator()(int i, int j) const { return i == 0 ? top[j].first() : i == 1 ? top[j].second() : bottom[j]; }
  Vec3T<T> column(int j) const { return {top[j].first(), top[j].second(), bottom[j]}; }
  Vec3T<T> last_row() const { return {bottom[0], bottom[1], bottom[2]}; }
};

/// R B R^T.
template <typename T>
[[gnu::always_inline]] inline SplitMat3T<T> rotated(const TwinRotationT<T>& R2, const Mat3T<T>& R,
                                                    const SplitMat3T<T>& B) {
  // R B, whose columns 0 and 1 are the twins here.
  const TwinVec3T<T> left({B.top[0].first(), B.top[1].first()}, {B.top[0].second(), B.top[1].second()},
                          {B.bottom[0], B.bottom[1]});
  const Vec3T<T> right = B.column(2);
  const TwinVec3T<T> RB = R2 * left;
  const Vec3T<T> RB_2 = times(R, right);
  const TwinVec3T<T> rows({RB.x.first(), RB.y.first()}, {RB.x.second(), RB.y.second()}, {RB_2[0], RB_2[1]});
  const Vec3T<T> last(RB.z.first(), RB.z.second(), RB_2[2]);
  const Vec3T<T> bottom = times(R, last);
  return {{R2.row(0).dot(rows), R2.row(1).dot(rows), R2.row(2).dot(rows)}, {bottom[0], bottom[1], bottom[2]}};
}

}  // namespace armtune
