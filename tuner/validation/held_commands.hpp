#pragma once
// Looks up the command that acts at a time. Commands are held until the next one.

#include <algorithm>
#include <vector>

#include "core/common/types.hpp"
#include "tuner/validation/motion_commands.hpp"

namespace armtune::internal {

class HeldCommands {
 public:
  /// The commands must outlive this object.
  explicit HeldCommands(const MotionCommands& commands) : time_(commands.time), value_(commands.value) {}

  /// Returns the index of the last command at or before t [s]; 0 before the first one. Fast if t is near that
  /// of the call before.
  Eigen::Index index_at(double t) {
    if (t < time_[i_] || (i_ + kNear < time_.size() && t >= time_[i_ + kNear])) {
      const auto after = std::upper_bound(time_.begin(), time_.end(), t);
      i_ = after == time_.begin() ? 0 : static_cast<std::size_t>(after - time_.begin()) - 1;
    }
    while (i_ + 1 < time_.size() && time_[i_ + 1] <= t) ++i_;
    return static_cast<Eigen::Index>(i_);
  }
  /// Returns the command that acts at t (n).
  JointVector at(double t) { return value_.row(index_at(t)).transpose(); }

 private:
  static constexpr std::size_t kNear = 8;
  const std::vector<double>& time_;
  const Eigen::MatrixXd& value_;
  std::size_t i_ = 0;
};

}  // namespace armtune::internal
