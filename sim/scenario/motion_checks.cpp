#include "sim/scenario/motion_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "armtune/error.hpp"
#include "core/trajectory/linear_acceleration.hpp"

namespace armtune::internal {
namespace {

/// Largest differences of a row from the motion that the previous row gives, in position [rad, m] and
/// velocity [rad/s, m/s]. Numbers with six digits cause differences up to about this size.
constexpr double kPositionJump = 1e-5;
constexpr double kVelocityJump = 1e-4;
/// Tolerance of position limits, because planners have a tolerance too [rad, m].
constexpr double kBeyondLimit = 1e-6;
constexpr int kLooks = 32;
/// Range of positions [rad] up to which a joint without limits is not judged. A jump by one turn, as of an
/// angle that is kept within one turn, is no sign of degrees.
constexpr double kTwoTurns = 4.0 * std::numbers::pi;
constexpr double kDegrees = 180.0 / std::numbers::pi;

}  // namespace

void MotionChecks::check_position(int joint, double q, std::size_t point, bool between) const {
  const JointInfo& info = robot_.joints[static_cast<std::size_t>(joint)];
  const JointLimits& limits = info.limits;
  if (!limits.has_position) return;
  if (q >= limits.lower - kBeyondLimit && q <= limits.upper + kBeyondLimit) return;
  const double from_degrees = q * std::numbers::pi / 180.0;
  const bool degrees =
      std::abs(q) > 2.0 * std::numbers::pi && from_degrees >= limits.lower && from_degrees <= limits.upper;
  const std::string key = fmt::format("joint/{}/position", info.name);
  throw InputError(points_.where(point, key),
                   fmt::format("{}{} is {:.9g}, outside the joint's limits {:.6g} .. {:.6g}; {}",
                               between ? "between this point and the next, " : "", key, q, limits.lower,
                               limits.upper, degrees ? degrees_ : "plan the motion for this robot"))
      .with_value(fmt::format("{:.9g}", q), fmt::format("{:.6g} to {:.6g}", limits.lower, limits.upper));
}

void MotionChecks::at_points() const {
  for (std::size_t k = 0; k < points_.points.size(); ++k) {
    for (int i = 0; i < robot_.n(); ++i) check_position(i, points_.points[k].position[i], k, false);
  }
}

void MotionChecks::unlimited_joints(double speed) const {
  for (int i = 0; i < robot_.n(); ++i) {
    const JointInfo& info = robot_.joints[static_cast<std::size_t>(i)];
    const auto q = [&](std::size_t k) { return points_.points[k].position[i]; };
    if (info.limits.has_position) continue;
    double lowest = 0.0, highest = 0.0, fastest = 0.0;
    std::size_t fast = 0;
    for (std::size_t k = 1; k < points_.points.size(); ++k) {
      lowest = std::min(lowest, q(k) - q(0));
      highest = std::max(highest, q(k) - q(0));
      const double velocity = speed * std::abs(q(k) - q(k - 1)) / (points_.time[k] - points_.time[k - 1]);
      if (velocity > fastest) fast = k;
      fastest = std::max(fastest, velocity);
    }
    if (highest - lowest <= kTwoTurns || fastest <= std::sqrt(kDegrees) * info.limits.velocity) continue;
    const std::string key = fmt::format("joint/{}/position", info.name);
    throw InputError(
        points_.where(fast, key),
        fmt::format(
            "{} is {:.9g}, so the joint turns at {:.3g} rad/s on the way from the previous point, but "
            "its velocity limit is {:.3g} rad/s; {}, or leave more time between the points",
            key, q(fast), fastest, info.limits.velocity, degrees_))
        .with_value(fmt::format("{:.9g}", q(fast)),
                    fmt::format("a velocity of at most {:.3g} rad/s", info.limits.velocity));
  }
}

void MotionChecks::between_knots() const {
  for (std::size_t k = 0; k + 1 < points_.points.size(); ++k) {
    const MotionPoint<JointVector>& knot = points_.points[k];
    const double h = points_.time[k + 1] - points_.time[k];
    for (int i = 0; i < robot_.n(); ++i) {
      // The joint reverses where v + a s + j s^2 / 2 = 0. This form of the solution avoids cancellation.
      const double v = knot.velocity[i], a = knot.acceleration[i];
      const double j = (points_.points[k + 1].acceleration[i] - a) / h;
      const double root = std::sqrt(std::max(0.0, a * a - 2.0 * j * v));
      const double q = -(a + std::copysign(root, a));
      for (const double s : {q / j, 2.0 * v / q}) {
        if (!(s > 0.0 && s < h)) continue;
        check_position(i, knot.position[i] + s * (v + s * (a / 2.0 + s * j / 6.0)), k, true);
      }
    }
  }
}

void MotionChecks::between_points(const JointSpline& motion) const {
  for (std::size_t k = 0; k + 1 < points_.time.size(); ++k) {
    const double h = points_.time[k + 1] - points_.time[k];
    for (int look = 1; look < kLooks; ++look) {
      const JointVector q = motion.at(points_.time[k] + h * look / kLooks).position;
      for (int i = 0; i < robot_.n(); ++i) check_position(i, q[i], k, true);
    }
  }
}

void MotionChecks::steps() const {
  for (std::size_t k = 0; k + 1 < points_.points.size(); ++k) {
    const double h = points_.time[k + 1] - points_.time[k];
    const MotionPoint<JointVector>& row = points_.points[k + 1];
    const MotionPoint<JointVector> expected = linear_acceleration(points_.points[k], row.acceleration, h, h);
    for (int i = 0; i < robot_.n(); ++i) {
      const auto check = [&](const char* what, double value, double wanted, double most) {
        if (std::abs(value - wanted) <= most) return;
        const std::string key =
            fmt::format("joint/{}/{}", robot_.joints[static_cast<std::size_t>(i)].name, what);
        throw InputError(
            points_.where(k + 1, key),
            fmt::format(
                "{} is {:.9g}. It differs by {:.3g} from the value that the previous row gives if "
                "the acceleration changes linearly between the rows; at most {:g} is allowed. Give more rows, "
                "more digits, or accelerations that match",
                key, value, std::abs(value - wanted), most))
            .with_value(fmt::format("{:.9g}", value), fmt::format("{:.9g} within {:g}", wanted, most));
      };
      check("position", row.position[i], expected.position[i], kPositionJump);
      check("velocity", row.velocity[i], expected.velocity[i], kVelocityJump);
    }
  }
}

}  // namespace armtune::internal
