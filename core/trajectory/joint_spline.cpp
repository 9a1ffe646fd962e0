#include "core/trajectory/joint_spline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "armtune/error.hpp"
#include "core/trajectory/linear_acceleration.hpp"

namespace armtune::internal {

JointSpline::JointSpline(std::vector<double> time, std::vector<MotionPoint<JointVector>> knots)
    : time_(std::move(time)), knots_(std::move(knots)) {
  if (time_.size() < 2 || time_.size() != knots_.size()) {
    throw InputError(
        fmt::format("a joint motion has {} times and {} knots; give the same number of both, at least two",
                    time_.size(), knots_.size()))
        .with_value(std::to_string(time_.size()), "as many times as knots, at least 2");
  }
  for (std::size_t k = 1; k < time_.size(); ++k) {
    if (time_[k] > time_[k - 1]) continue;
    throw InputError(
        fmt::format("knot {} of a joint motion is at {} s, but the knot before it is at {} s; times must "
                    "increase",
                    k, time_[k], time_[k - 1]))
        .with_value(fmt::to_string(time_[k]), fmt::format("above {}", time_[k - 1]));
  }
}

JointSpline::JointSpline(std::vector<double> time, std::vector<MotionPoint<JointVector>> knots,
                         PointsGive given, BetweenPoints between)
    : JointSpline(std::move(time), std::move(knots)) {
  for (MotionPoint<JointVector>& knot : knots_) {
    if (given == PointsGive::kPositions) knot.velocity.setZero(knot.position.size());
    if (given != PointsGive::kAccelerations) knot.acceleration.setZero(knot.position.size());
  }
  jumps_ = between == BetweenPoints::kNextPoint;
  if (!jumps_) segments_ = ros_segments(time_, knots_, given);
}

MotionPoint<JointVector> JointSpline::at(double t) const {
  if (jumps_) {
    const auto later = std::upper_bound(time_.begin(), time_.end() - 1, t);
    return knots_[static_cast<std::size_t>(later - time_.begin())];
  }
  if (!segments_.empty() && t >= end()) return knots_.back();
  const double inside = std::clamp(t, begin(), end());
  const auto next = std::upper_bound(time_.begin() + 1, time_.end() - 1, inside);
  const auto k = static_cast<std::size_t>(next - time_.begin()) - 1;
  const double s = inside - time_[k];
  if (!segments_.empty()) return segments_[k].at(s);
  return linear_acceleration(knots_[k], knots_[k + 1].acceleration, time_[k + 1] - time_[k], s);
}

JointVector JointSpline::mean_acceleration(double t, double dt) const {
  const double from = std::max(t, begin());
  const double to = std::min(t + dt, end());
  if (!(to > from)) return at(t).acceleration;
  return (at(to).velocity - at(from).velocity) / (to - from);
}

}  // namespace armtune::internal
