#include "core/trajectory/position_spline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armtune/error.hpp"

namespace armtune::internal {
namespace {

constexpr double kRounding = 1e-9;

bool same(const MotionPoint<Vec3>& a, const MotionPoint<Vec3>& b) {
  const auto close = [](const Vec3& x, const Vec3& y) {
    return (x - y).norm() <= kRounding * (1.0 + std::max(x.norm(), y.norm()));
  };
  return close(a.position, b.position) && close(a.velocity, b.velocity) &&
         close(a.acceleration, b.acceleration);
}

}  // namespace

PositionSpline::PositionSpline(const std::vector<double>& time, const std::vector<MotionPoint<Vec3>>& knots,
                               bool loops)
    : time_(time), knots_(knots), loops_(loops) {
  if (time_.size() < 2 || time_.size() != knots_.size()) {
    throw InputError(fmt::format("a motion has {} times and {} knots; give the same number of both, at least "
                                 "two",
                                 time_.size(), knots_.size()))
        .with_value(std::to_string(time_.size()), "as many times as knots, at least 2");
  }
  for (std::size_t k = 1; k < time_.size(); ++k) {
    const double duration = time_[k] - time_[k - 1];
    if (!(duration > 0.0)) {
      throw InputError(
          fmt::format("knot {} of a motion is at {} s, but the knot before it is at {} s; times must "
                      "increase",
                      k, time_[k], time_[k - 1]))
          .with_value(fmt::to_string(time_[k]), fmt::format("above {}", time_[k - 1]));
    }
    pieces_.emplace_back(knots_[k - 1], knots_[k], duration);
  }
  if (loops_ && !same(knots_.front(), knots_.back())) {
    throw InputError("a looping motion must end with the position, velocity and acceleration of its start")
        .with_value({}, "an end like the start");
  }
}

std::optional<double> PositionSpline::inside(double t) const {
  if (loops_) {
    const double turn = end() - begin();
    return t - turn * std::floor((t - begin()) / turn);
  }
  if (!(t >= begin() && t <= end())) return std::nullopt;
  return t;
}

std::pair<std::size_t, double> PositionSpline::piece(double t) const {
  const auto next = std::upper_bound(time_.begin() + 1, time_.end() - 1, t);
  const auto k = static_cast<std::size_t>(next - time_.begin()) - 1;
  return {k, t - time_[k]};
}

MotionPoint<Vec3> PositionSpline::at(double t) const {
  const std::optional<double> now = inside(t);
  if (!now) {
    const MotionPoint<Vec3>& last = t > end() ? knots_.back() : knots_.front();
    return {last.position, Vec3::Zero(), Vec3::Zero()};
  }
  const auto [k, since] = piece(*now);
  return pieces_[k].at(since);
}

Vec3 PositionSpline::jerk(double t) const {
  const std::optional<double> now = inside(t);
  if (!now) return Vec3::Zero();
  const auto [k, since] = piece(*now);
  return pieces_[k].jerk(since);
}

}  // namespace armtune::internal
