#include "core/control/laws/position_servo.hpp"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

namespace armtune::internal {

PositionServo::PositionServo(const RobotModel& model, const ServoGains& gains, double period)
    : period_(period),
      most_(model.velocity_limits()),
      position_(JointVector::Zero(model.n())),
      velocity_(JointVector::Zero(model.n())) {
  const double g = gains.gain;
  Eigen::Matrix2d A;
  A << 0.0, 1.0, -g, -g * gains.lookahead_time;
  transition_ = (period * A).exp();
  for (int i = 0; i < model.n(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    turns_[k] = !model.joints[k].limits.has_position;
  }
}

void PositionServo::start(const JointVector& q) {
  position_ = q;
  velocity_.setZero();
}

void PositionServo::step(const JointVector& commanded) {
  for (Eigen::Index i = 0; i < position_.size(); ++i) {
    double away = position_[i] - commanded[i];
    if (turns_[static_cast<std::size_t>(i)]) away = std::remainder(away, 2.0 * M_PI);
    const Eigen::Vector2d next = transition_ * Eigen::Vector2d(away, velocity_[i]);
    const double velocity = std::clamp(next[1], -most_[i], most_[i]);
    // If the limit acts, the acceleration is taken as constant within the period.
    position_[i] += velocity == next[1] ? next[0] - away : 0.5 * period_ * (velocity_[i] + velocity);
    velocity_[i] = velocity;
  }
}

}  // namespace armtune::internal
