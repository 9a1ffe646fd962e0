#pragma once
// Computes velocities and accelerations at waypoints (knots) for which only positions and times are given.
// They are taken from the cubic spline through the knots that is at rest at both ends (de Boor, A Practical
// Guide to Splines, chapter IV). A quintic between two knots with these values equals the cubic, so its
// acceleration is linear in time.

#include <vector>

#include "core/trajectory/motion_point.hpp"

namespace armtune::internal {

/// Returns the knots of the spline with their positions, velocities and accelerations. V: an Eigen vector of
/// any size. time [s]: increasing, as many as positions, at least two.
template <typename V>
std::vector<MotionPoint<V>> cubic_spline(const std::vector<double>& time, const std::vector<V>& positions) {
  const std::size_t n = time.size();
  const V zero = V::Zero(positions.front().size());
  std::vector<MotionPoint<V>> knots;
  knots.reserve(n);
  for (const V& position : positions) knots.push_back({position, zero, zero});
  const auto h = [&](std::size_t k) { return time[k + 1] - time[k]; };
  const auto slope = [&](std::size_t k) { return V((positions[k + 1] - positions[k]) / h(k)); };
  // The accelerations on both sides of each inner knot k are equal. This gives a tridiagonal system for the
  // velocities v, which is solved by elimination from the first knot to the last:
  //   v[k-1] / h[k-1] + 2 (1 / h[k-1] + 1 / h[k]) v[k] + v[k+1] / h[k] = 3 (slope[k-1] / h[k-1] + slope[k] /
  //   h[k]).
  std::vector<double> after(n, 0.0);  // v[k] = known[k] - after[k] v[k+1]
  std::vector<V> known(n, zero);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const double a = 1.0 / h(k - 1);
    const double c = 1.0 / h(k);
    const double pivot = 2.0 * (a + c) - a * after[k - 1];
    after[k] = c / pivot;
    known[k] = (3.0 * (a * slope(k - 1) + c * slope(k)) - a * known[k - 1]) / pivot;
  }
  for (std::size_t k = n - 1; k-- > 1;) knots[k].velocity = known[k] - after[k] * knots[k + 1].velocity;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    knots[k].acceleration = (6.0 * slope(k) - 4.0 * knots[k].velocity - 2.0 * knots[k + 1].velocity) / h(k);
  }
  knots[n - 1].acceleration = (2.0 * knots[n - 2].velocity - 6.0 * slope(n - 2)) / h(n - 2);
  return knots;
}

}  // namespace armtune::internal
