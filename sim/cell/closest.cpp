#include "sim/cell/closest.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>

namespace armtune::internal {
namespace {

constexpr double kProof =
    1e-9;  // m: accuracy to which the distance is proven; bodies closer than this count as touching
constexpr double kGone = 1e-13;  // largest weight of a point that is removed
constexpr int kMostSteps = 200;

/// A point a - b of the Minkowski difference of the two bodies.
struct Difference {
  Vec3 a = Vec3::Zero();
  Vec3 b = Vec3::Zero();
  Vec3 ab() const { return a - b; }
};

/// Up to four points of the difference (the corral of Wolfe's algorithm) and their weights. After settle(),
/// the weights give the point of least norm of the points' convex hull.
class Corral {
 public:
  explicit Corral(const Difference& first) : points_{first} {}

  int size() const { return size_; }
  Vec3 a() const {
    return sum([](const Difference& p) { return p.a; });
  }
  Vec3 b() const {
    return sum([](const Difference& p) { return p.b; });
  }
  Vec3 nearest() const {
    return sum([](const Difference& p) { return p.ab(); });
  }

  void add(const Difference& point) {
    const auto k = static_cast<std::size_t>(size_++);
    points_[k] = point;
    weights_[k] = 0.0;
  }

  /// Moves to the point of least norm of the points' convex hull, and removes the points whose weight is zero
  /// there.
  void settle() {
    while (true) {
      const std::array<double, 4> wanted = affine_weights();
      double share = 1.0;
      for (int i = 0; i < size_; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (wanted[k] <= kGone) share = std::min(share, weights_[k] / (weights_[k] - wanted[k]));
      }
      for (int i = 0; i < size_; ++i) {
        const auto k = static_cast<std::size_t>(i);
        weights_[k] += share * (wanted[k] - weights_[k]);
      }
      const int before = size_;
      drop_gone();
      if (share == 1.0 || size_ == before) return;
    }
  }

 private:
  template <typename Part>
  Vec3 sum(Part&& part) const {
    Vec3 total = Vec3::Zero();
    for (int i = 0; i < size_; ++i) {
      const auto k = static_cast<std::size_t>(i);
      total += weights_[k] * part(points_[k]);
    }
    return total;
  }

  /// Returns the point of least norm of the points' affine hull, as weights that sum to 1.
  std::array<double, 4> affine_weights() const {
    std::array<double, 4> weights{1.0, 0.0, 0.0, 0.0};
    if (size_ == 1) return weights;
    const Vec3 first = points_[0].ab();
    Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> edges(3, size_ - 1);
    for (int i = 1; i < size_; ++i) edges.col(i - 1) = points_[static_cast<std::size_t>(i)].ab() - first;
    const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> shares =
        Eigen::ColPivHouseholderQR<decltype(edges)>(edges).solve(-first);
    for (int i = 1; i < size_; ++i) {
      weights[static_cast<std::size_t>(i)] = shares[i - 1];
      weights[0] -= shares[i - 1];
    }
    return weights;
  }

  void drop_gone() {
    int kept = 0;
    for (int i = 0; i < size_; ++i) {
      const auto from = static_cast<std::size_t>(i);
      if (weights_[from] <= kGone) continue;
      const auto to = static_cast<std::size_t>(kept++);
      points_[to] = points_[from];
      weights_[to] = weights_[from];
    }
    size_ = kept;
  }

  std::array<Difference, 4> points_;
  std::array<double, 4> weights_{1.0, 0.0, 0.0, 0.0};
  int size_ = 1;
};

}  // namespace

Closest closest(const Solid& a, const Mat3& R_a, const Vec3& p_a, const Solid& b, const Mat3& R_b,
                const Vec3& p_b) {
  const auto farthest_along = [&](const Vec3& d) {
    return Difference{p_a + R_a * extreme_of_core(a, R_a.transpose() * d),
                      p_b + R_b * extreme_of_core(b, -(R_b.transpose() * d))};
  };
  Corral corral(farthest_along(p_b - p_a));
  Vec3 x = corral.nearest();
  double proven = 0.0;
  for (int step = 0; step < kMostSteps && x.norm() > kProof; ++step) {
    const Difference next = farthest_along(-x);
    proven = x.dot(next.ab()) / x.norm();
    if (x.norm() - proven <= kProof) break;
    corral.add(next);
    corral.settle();
    // Four remaining points enclose the origin: the bodies overlap.
    x = corral.size() < 4 ? corral.nearest() : Vec3::Zero();
  }
  Closest found;
  // If the accuracy was not reached, the result is the proven lower bound.
  const double apart = x.norm() - proven <= kProof ? x.norm() : proven;
  const double radii = a.radius + b.radius;
  if (!(apart > kProof)) {
    found.distance = radii > 0.0 ? -radii : -kProof;
    found.on_a = found.on_b = 0.5 * (p_a + p_b);
    if ((p_a - p_b).norm() > 0.0) found.away = (p_a - p_b).normalized();
    return found;
  }
  found.distance = apart - radii;
  found.away = x.normalized();
  found.on_a = corral.a() - a.radius * found.away;
  found.on_b = corral.b() + b.radius * found.away;
  return found;
}

}  // namespace armtune::internal
