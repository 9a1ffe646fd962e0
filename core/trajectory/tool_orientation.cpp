#include "core/trajectory/tool_orientation.hpp"

#include <algorithm>
#include <cmath>

#include "core/trajectory/cubic_spline.hpp"
#include "core/trajectory/gaze_motion.hpp"

namespace armtune::internal {
namespace {

/// A path that does not loop rests at its ends and has no direction there. The direction is taken at this
/// distance in time from an end, as a share of the first or last piece of the spline.
constexpr double kOffTheEnd = 1e-3;

/// Returns the unit vector of a nonzero vector, with its derivatives.
MotionPoint<Vec3> unit(const MotionPoint<Vec3>& v) {
  return gaze_direction({Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}, v);
}

/// Returns the orientation with this x axis and with z nearest to a: z = unit(a - (a . x) x), y = z x x.
OrientationPoint framed(const MotionPoint<Vec3>& x, const Vec3& a) {
  const double along = a.dot(x.position);
  const double along_dot = a.dot(x.velocity);
  const double along_ddot = a.dot(x.acceleration);
  const MotionPoint<Vec3> z =
      unit({a - along * x.position, -along_dot * x.position - along * x.velocity,
            -along_ddot * x.position - 2.0 * along_dot * x.velocity - along * x.acceleration});
  const MotionPoint<Vec3> y{z.position.cross(x.position),
                            z.velocity.cross(x.position) + z.position.cross(x.velocity),
                            z.acceleration.cross(x.position) + 2.0 * z.velocity.cross(x.velocity) +
                                z.position.cross(x.acceleration)};
  Mat3 R;
  R << x.position, y.position, z.position;
  // Every axis e obeys e' = w x e, so that w = sum e x e' / 2 and w' = sum e x e'' / 2.
  OrientationPoint point{Eigen::Quaterniond(R), Vec3::Zero(), Vec3::Zero()};
  for (const MotionPoint<Vec3>* e : {&x, &y, &z}) {
    point.angular_velocity += 0.5 * e->position.cross(e->velocity);
    point.angular_acceleration += 0.5 * e->position.cross(e->acceleration);
  }
  return point;
}

}  // namespace

MotionPoint<Vec3> heading(const Path& path, double t) {
  bool stands = false;
  if (path.spline && !path.spline->loops()) {
    const std::vector<double>& knots = path.spline->time();
    const std::size_t last = knots.size() - 1;
    const auto own_time = [&](double spline_time) {
      return (spline_time - path.spline_lead) / path.spline_rate;
    };
    const double inside = std::clamp(t, own_time(knots[0] + kOffTheEnd * (knots[1] - knots[0])),
                                     own_time(knots[last] - kOffTheEnd * (knots[last] - knots[last - 1])));
    stands = inside != t;
    t = inside;
  }
  const MotionPoint<Vec3> point = path.at(t);
  MotionPoint<Vec3> u = unit({point.velocity, point.acceleration, path.jerk(t)});
  if (stands) u.velocity = u.acceleration = Vec3::Zero();
  return u;
}

OrientationPoint ToolOrientation::at(double t, const Path& path) const {
  if (approach) return framed(heading(path, t), *approach);
  if (!turn) return {start, Vec3::Zero(), Vec3::Zero()};
  const MotionPoint<Vec3> phi = turn->at(t);
  const TurnRate rate = rotation_rate(phi);
  return {rotation_exp(phi.position) * start, rate.velocity, rate.acceleration};
}

ToolOrientation turning_through(const std::vector<double>& time,
                                const std::vector<Eigen::Quaterniond>& orientations) {
  ToolOrientation result;
  result.start = orientations.front();
  std::vector<Vec3> turns;
  turns.reserve(orientations.size());
  Vec3 last = Vec3::Zero();
  for (const Eigen::Quaterniond& orientation : orientations) {
    last = nearest_rotation_vector(rotation_log(orientation * result.start.conjugate()), last);
    turns.push_back(last);
  }
  result.turn = std::make_shared<const PositionSpline>(time, cubic_spline(time, turns), false);
  return result;
}

}  // namespace armtune::internal
