#pragma once
// A filter that estimates a point's motion from noisy samples of its position, such as those of a camera. It
// is a fading-memory polynomial filter of the second degree (critically damped g-h-k filter): Brookner,
// Tracking and Kalman Filtering Made Easy, section 1.4. In every period dt it predicts position p, velocity v
// and acceleration a, and corrects them by the residual r, which is the sample minus the predicted position:
//   p += g r,  v += h r / dt,  a += 2 k r / dt^2,
//   g = 1 - beta^3,  h = 3/2 (1 - beta)^2 (1 + beta),  k = 1/2 (1 - beta)^3,  beta = exp(-bandwidth * dt).
// The estimate follows a point of constant acceleration without lag.

#include <cmath>

#include "core/common/types.hpp"
#include "core/trajectory/motion_point.hpp"

namespace armtune::internal {

class MotionFilter {
 public:
  /// bandwidth > 0 [rad/s]: a higher one follows faster, a lower one passes less noise. period: time between
  /// samples [s].
  MotionFilter(double bandwidth, double period) : period_(period) {
    const double beta = std::exp(-bandwidth * period);
    const double rest = 1.0 - beta;
    g_ = 1.0 - beta * beta * beta;
    h_ = 1.5 * rest * rest * (1.0 + beta) / period;
    k2_ = rest * rest * rest / (period * period);
  }

  /// Takes the sample of this period [m] and returns the estimate for the same instant. The first estimate is
  /// at rest at the first sample.
  const MotionPoint<Vec3>& update(const Vec3& sample) {
    if (!started_) {
      started_ = true;
      motion_ = {sample, Vec3::Zero(), Vec3::Zero()};
      return motion_;
    }
    motion_.position += period_ * (motion_.velocity + 0.5 * period_ * motion_.acceleration);
    motion_.velocity += period_ * motion_.acceleration;
    const Vec3 residual = sample - motion_.position;
    motion_.position += g_ * residual;
    motion_.velocity += h_ * residual;
    motion_.acceleration += k2_ * residual;
    return motion_;
  }

 private:
  double period_;
  double g_;
  double h_;
  double k2_;
  bool started_ = false;
  MotionPoint<Vec3> motion_{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
};

}  // namespace armtune::internal
