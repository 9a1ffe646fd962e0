#include "core/trajectory/ros_segments.hpp"

namespace armtune::internal {
namespace {

using Point = MotionPoint<JointVector>;

/// Sets velocities and accelerations at the ends of the straight line over T [s].
void fill_line(Point& from, Point& to, double T) {
  from.velocity = to.velocity = (to.position - from.position) / T;
  from.acceleration = to.acceleration = JointVector::Zero(from.position.size());
}

/// Sets the accelerations at the ends of the cubic over T [s], whose positions and velocities are given.
void fill_cubic(Point& from, Point& to, double T) {
  const JointVector slope = (to.position - from.position) / T;
  from.acceleration = (6.0 * slope - 4.0 * from.velocity - 2.0 * to.velocity) / T;
  to.acceleration = (2.0 * from.velocity + 4.0 * to.velocity - 6.0 * slope) / T;
}

}  // namespace

std::vector<Quintic<JointVector>> ros_segments(const std::vector<double>& time,
                                               const std::vector<Point>& points, PointsGive given) {
  std::vector<Quintic<JointVector>> segments;
  segments.reserve(points.size());
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const double T = time[k + 1] - time[k];
    Point from = points[k], to = points[k + 1];
    if (given == PointsGive::kPositions) fill_line(from, to, T);
    if (given == PointsGive::kVelocities) fill_cubic(from, to, T);
    segments.emplace_back(from, to, T);
  }
  return segments;
}

}  // namespace armtune::internal
