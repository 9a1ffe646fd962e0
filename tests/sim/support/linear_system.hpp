#pragma once
// The sines of the bundled scenarios, and a linear system that is driven by a stimulus.

#include <functional>
#include <vector>

#include "sim/scenario/scenario.hpp"

namespace armtune::internal::test {

inline Stimulus bundled_sines() {
  return *load_scenario("sines_position").stimulus;
}

/// x' = A x + b u(t) from rest by Runge-Kutta 4 in steps of 0.5 ms; calls seen(t, u, c . x) each `period` [s]
/// of whole steps. Its error is of order (w h)^4 / 120: 1e-8 of a pole at 40 rad/s.
template <int N>
void drive(const Eigen::Matrix<double, N, N>& A, const Eigen::Matrix<double, N, 1>& b,
           const Eigen::Matrix<double, N, 1>& c, const std::function<double(double)>& u, double period,
           double end, const std::function<void(double, double, double)>& seen) {
  using Vec = Eigen::Matrix<double, N, 1>;
  constexpr double kStep = 5e-4;
  const long per_period = std::lround(period / kStep);
  const long steps = std::lround(end / kStep);
  Vec x = Vec::Zero();
  for (long k = 0; k < steps; ++k) {
    const double t = static_cast<double>(k) * kStep;
    if (k % per_period == 0) seen(t, u(t), c.dot(x));
    // The value at the step's own start: a stimulus that begins there is already on.
    const double u0 = u(t);
    const double u1 = u(t + 0.5 * kStep);
    const double u2 = u(t + kStep);
    const Vec k1 = A * x + b * u0;
    const Vec k2 = A * (x + 0.5 * kStep * k1) + b * u1;
    const Vec k3 = A * (x + 0.5 * kStep * k2) + b * u1;
    const Vec k4 = A * (x + kStep * k3) + b * u2;
    x += kStep / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
}

}  // namespace armtune::internal::test
