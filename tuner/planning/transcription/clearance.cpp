// Limits on the arm's distance from obstacles (arm_terms.hpp).

#include <algorithm>
#include <limits>

#include "tuner/planning/transcription/joint_axis.hpp"
#include "tuner/planning/transcription/term_parts.hpp"

namespace armtune::internal {
namespace {

/// Returns the first joint whose origin can move. If joint 0 is revolute, its origin is fixed.
int first_moving_origin(const Chain& chain) {
  return chain.motion[0] == JointMotion::kRevolute ? 1 : 0;
}

/// Returns the origin of joint i. If i is the number of joints, returns the tool's position.
const Vec3& point(const Poses& poses, int i) {
  return i < poses.n ? poses.p_0B[static_cast<std::size_t>(i)] : poses.p_0T;
}

}  // namespace

KnotTerm clear_of(const RobotModel& robot, KnotRange knots, const MovingObstacle& obstacle, double radius) {
  const int first_joint = first_moving_origin(robot.chain);
  std::vector<std::string> rows = joint_names(robot);
  rows.erase(rows.begin(), rows.begin() + first_joint);
  rows.emplace_back("tool");
  KnotTerm term = over(knots, "distance to " + obstacle.name, rows);
  term.kind = LimitKind::kObstacle;
  in_meters(1.0 / radius, term);
  term.on_time = true;
  term.lower = 1.0;
  term.evaluate = [chain = robot.chain, obstacle, radius, first_joint](const Knot& knot,
                                                                       const KnotRows& out) {
    const MotionPoint<Vec3> at = obstacle.path.at(knot.time);
    for (int i = first_joint; i <= chain.n; ++i) {
      const int row = i - first_joint;
      const bool tool = i == chain.n;
      const Vec3 p = point(knot.poses, i);
      const Vec3 away = p - at.position;
      const double distance = away.norm();
      out.value[row] = (distance - obstacle.radius) / radius;
      if (out.by_q == nullptr) continue;
      const Vec3 direction = distance > 0.0 ? Vec3(away / (distance * radius)) : Vec3(Vec3::UnitZ() / radius);
      for (int j = 0; j < i; ++j)
        out.by_q[row * out.columns + j] = direction.dot(point_rate(axis_of(chain, knot.poses, j), p));
      // A prismatic joint moves its own origin.
      if (!tool && chain.motion[static_cast<std::size_t>(i)] == JointMotion::kPrismatic)
        out.by_q[row * out.columns + i] = direction.dot(axis_of(chain, knot.poses, i).z);
      out.by_time[row] = -direction.dot(at.velocity);
    }
  };
  return term;
}

double clearance_at(const Chain& chain, const Poses& poses, double time,
                    const std::vector<MovingObstacle>& obstacles) {
  double least = std::numeric_limits<double>::infinity();
  for (const MovingObstacle& moving : obstacles) {
    const Obstacle obstacle = moving.at(time);
    for (int i = first_moving_origin(chain); i <= chain.n; ++i)
      least = std::min(least, (point(poses, i) - obstacle.center).norm() - obstacle.radius);
  }
  return least;
}

}  // namespace armtune::internal
