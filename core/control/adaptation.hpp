#pragma once
// Model compensation and its adaptation (equations 5 and 6):
//   theta <- theta - gamma Y^T S dt,   S = q' - qr';   compensation torque Y theta.
// Two things keep theta from wandering off on noise; the published law has neither: leakage and projection.

#include "core/robot/physical_theta.hpp"
#include "core/robot/slotine_li.hpp"

namespace armtune {

class Adaptation {
 public:
  explicit Adaptation(const ParameterVector& theta) : start_(theta), theta_(theta), gradient_(theta) {}

  const ParameterVector& theta() const { return theta_; }

  /// One explicit Euler step of length dt [s]; `motion` holds Y and S of this period.
  void step(const SlotineLi& motion, double gamma, double dt) {
    slotine_li_gradient(motion, gradient_);
    theta_ -= (gamma * dt) * gradient_;
  }

  /// Leakage (Ioannou and Kokotovic's sigma modification): theta <- theta - rate (theta - start) dt. rate
  /// [1/s].
  void leak(double rate, double dt) { theta_ -= (rate * dt) * (theta_ - start_); }

  /// Moves theta to the nearest physically valid one (physical_theta.hpp).
  void project() { project_to_physical(theta_); }

 private:
  ParameterVector start_;
  ParameterVector theta_;
  ParameterVector gradient_;
};

}  // namespace armtune
