#pragma once
// A few instants of the logs' filtered motion, spread evenly over all that was read: enough to compare a log
// with the robot file in many ways without reading it again.

#include <vector>

#include "core/common/types.hpp"

namespace armtune {

struct LogInstant {
  JointVector q;    ///< [rad, m]
  JointVector qd;   ///< [rad/s, m/s]
  JointVector qdd;  ///< [rad/s^2, m/s^2]
  JointVector torque;
};

/// Keeps every 2^k-th instant, with k as large as the number of instants needs.
class LogInstants {
 public:
  static constexpr std::size_t kMost = 2000;

  void add(const LogInstant& instant) {
    if (seen_++ % step_ != 0) return;
    kept_.push_back(instant);
    if (kept_.size() <= kMost) return;
    for (std::size_t i = 0; 2 * i < kept_.size(); ++i) kept_[i] = kept_[2 * i];
    kept_.resize((kept_.size() + 1) / 2);
    step_ *= 2;
  }

  const std::vector<LogInstant>& kept() const { return kept_; }

 private:
  std::vector<LogInstant> kept_;
  std::size_t step_ = 1;
  std::size_t seen_ = 0;
};

}  // namespace armtune
