#pragma once
// Model compensation and its adaptation (equations 5 and 6):
//   theta <- theta - gamma Y^T S dt,   S = q' - qr';   compensation torque Y theta.

#include "core/robot/slotine_li.hpp"

namespace armtune {

class Adaptation {
 public:
  explicit Adaptation(const ParameterVector& theta) : theta_(theta), gradient_(theta) {}

  const ParameterVector& theta() const { return theta_; }

  /// One explicit Euler step of length dt [s]; `motion` holds Y and S of this period.
  void step(const SlotineLi& motion, double gamma, double dt) {
    slotine_li_gradient(motion, gradient_);
    theta_ -= (gamma * dt) * gradient_;
  }

 private:
  ParameterVector theta_;
  ParameterVector gradient_;
};

}  // namespace armtune
