// Cost and limit on the angle between the tool's z axis and the line to a target (arm_terms.hpp).

#include <cmath>

#include "tuner/planning/transcription/joint_axis.hpp"
#include "tuner/planning/transcription/term_parts.hpp"
#include "tuner/record/words.hpp"

namespace armtune::internal {
namespace {

/// Returns the derivative of the unit vector u = line / length, for a given derivative of the line.
Vec3 direction_rate(const Vec3& u, double length, const Vec3& line_rate) {
  return (line_rate - u * u.dot(line_rate)) / length;
}

/// The x and y components of the unit vector from the tool to the target, in the tool frame. They are zero if
/// the tool's z axis points at the target.
struct GazeError {
  Eigen::Vector2d value;
  Eigen::Matrix<double, 2, kMaxJoints> by_q;
  Eigen::Vector2d by_time;
};

void gaze_error(const Chain& chain, const Knot& knot, const MotionPoint<Vec3>& target, bool derivatives,
                GazeError& out) {
  const Vec3 line = target.position - knot.poses.p_0T;
  const double distance = line.norm();
  const Vec3 u = line / distance;
  const Mat3& R = knot.poses.R_0T;
  out.value = {R.col(0).dot(u), R.col(1).dot(u)};
  if (!derivatives) return;
  for (int i = 0; i < chain.n; ++i) {
    const JointAxis axis = axis_of(chain, knot.poses, i);
    Vec3 rate = direction_rate(u, distance, -point_rate(axis, knot.poses.p_0T));
    if (axis.turns) rate += u.cross(axis.z);  // derivative of R^T: the tool frame turns
    out.by_q.col(i) = Eigen::Vector2d(R.col(0).dot(rate), R.col(1).dot(rate));
  }
  const Vec3 rate = direction_rate(u, distance, target.velocity);
  out.by_time = {R.col(0).dot(rate), R.col(1).dot(rate)};
}

}  // namespace

KnotTerm gaze_cost(const RobotModel& robot, KnotRange knots, const Path& target, double weight) {
  KnotTerm term = over(knots, kept_words::kGaze, {"about y", "about x"});
  term.on_time = true;
  term.cost = true;
  const double factor = std::sqrt(weight);
  term.evaluate = [chain = robot.chain, target, factor](const Knot& knot, const KnotRows& out) {
    GazeError error;
    gaze_error(chain, knot, target.at(knot.time), out.by_q != nullptr, error);
    for (int i = 0; i < 2; ++i) {
      out.value[i] = factor * error.value[i];
      if (out.by_q == nullptr) continue;
      for (int j = 0; j < chain.n; ++j) out.by_q[i * out.columns + j] = factor * error.by_q(i, j);
      out.by_time[i] = factor * error.by_time[i];
    }
  };
  return term;
}

KnotTerm gaze_within(const RobotModel& robot, KnotRange knots, const Path& target, double angle) {
  KnotTerm term = over(knots, kept_words::kGaze, {"angle"});
  term.kind = LimitKind::kGaze;
  term.on_time = true;
  term.upper = 1.0;
  const double half = std::sin(0.5 * angle);
  // The row is sin^2(angle/2) = (1 - cos(angle))/2, divided by its limit. It is smooth, and increases up
  // to an angle of 180 degrees.
  const double factor = 0.5 / (half * half);
  term.units = {"rad"};
  term.natural = [half](std::size_t, double value) {
    return 2.0 * std::asin(std::min(1.0, half * std::sqrt(std::max(0.0, value))));
  };
  term.evaluate = [chain = robot.chain, target, factor](const Knot& knot, const KnotRows& out) {
    const MotionPoint<Vec3> at = target.at(knot.time);
    const Vec3 line = at.position - knot.poses.p_0T;
    const double distance = line.norm();
    const Vec3 u = line / distance;
    const Vec3 z = knot.poses.R_0T.col(2);
    // 1 - cos(angle) = |u - z|^2 / 2. This form loses no digits at small angles.
    const Vec3 apart = u - z;
    out.value[0] = factor * 0.5 * apart.squaredNorm();
    if (out.by_q == nullptr) return;
    for (int j = 0; j < chain.n; ++j) {
      const JointAxis axis = axis_of(chain, knot.poses, j);
      Vec3 rate = direction_rate(u, distance, -point_rate(axis, knot.poses.p_0T));
      if (axis.turns) rate -= axis.z.cross(z);
      out.by_q[j] = factor * apart.dot(rate);
    }
    out.by_time[0] = factor * apart.dot(direction_rate(u, distance, at.velocity));
  };
  return term;
}

}  // namespace armtune::internal
