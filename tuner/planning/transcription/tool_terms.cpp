// Limits and costs that keep the tool on a path in time, or on a curve (arm_terms.hpp).

#include <cmath>

#include "core/common/dual.hpp"
#include "core/robot/chain_cast.hpp"
#include "tuner/planning/transcription/joint_axis.hpp"
#include "tuner/planning/transcription/term_parts.hpp"
#include "tuner/record/words.hpp"

namespace armtune::internal {
namespace {

/// Returns the factor on the tool's distance from its path: 1 / tolerance, or 1 if the tolerance is 0.
double path_factor(double tolerance) {
  return tolerance > 0.0 ? 1.0 / tolerance : 1.0;
}

KnotTerm path_term(KnotRange knots, double tolerance) {
  KnotTerm term = over(knots, kept_words::kToolPath, {"x", "y", "z"});
  term.kind = LimitKind::kToolPath;
  term.lower = tolerance > 0.0 ? -1.0 : 0.0;
  term.upper = -term.lower;
  in_meters(path_factor(tolerance), term);
  return term;
}

/// Computes factor * (tool position - wanted), and its derivatives with respect to q.
void tool_offset(const Chain& chain, const Knot& knot, const Vec3& wanted, double factor,
                 const KnotRows& out) {
  Eigen::Map<Vec3> value(out.value);
  value = factor * (knot.poses.p_0T - wanted);
  if (out.by_q == nullptr) return;
  for (int i = 0; i < chain.n; ++i)
    put(out.by_q, out.columns, i, factor * point_rate(axis_of(chain, knot.poses, i), knot.poses.p_0T));
}

using Along = Dual<kMaxJoints>;

/// Writes d(J q'' + J' q')/dq for the linear part of J, row by row.
void add_acceleration_along_q(const ChainT<Along>& chain, const Knot& at, double* rows, int columns) {
  JointVectorT<Along> q = at.q.cast<Along>();
  for (int i = 0; i < chain.n; ++i) q[i].slope[i] = 1.0;
  const JointVectorT<Along> qd = at.qd.cast<Along>();
  const JointVectorT<Along> qdd = at.qdd.cast<Along>();
  PosesT<Along> poses;
  forward_kinematics(chain, q, poses);
  JacobianT<Along> J;
  tool_jacobian(chain, poses, J);
  JacobianT<Along> J_dot;
  tool_jacobian_derivative(chain, poses, J, qd, J_dot);
  const Vec6T<Along> acceleration = J * qdd + J_dot * qd;
  for (int row = 0; row < 3; ++row) {
    for (int i = 0; i < chain.n; ++i) rows[row * columns + i] = acceleration[row].slope[i];
  }
}

}  // namespace

KnotTerm tool_on_path(const RobotModel& robot, KnotRange knots, const Path& path, double tolerance) {
  const double factor = path_factor(tolerance);
  KnotTerm term = path_term(knots, tolerance);
  term.on_time = true;
  term.evaluate = [chain = robot.chain, path, factor](const Knot& knot, const KnotRows& out) {
    const MotionPoint<Vec3> at = path.at(knot.time);
    tool_offset(chain, knot, at.position, factor, out);
    if (out.by_q == nullptr) return;
    Eigen::Map<Vec3> by_time(out.by_time);
    by_time = -factor * at.velocity;
  };
  return term;
}

KnotTerm tool_path_cost(const RobotModel& robot, KnotRange knots, const Path& path, double weight) {
  KnotTerm term = tool_on_path(robot, knots, path, 1.0 / std::sqrt(weight));
  term.cost = true;
  return term;
}

KnotTerm tool_on_curve(const RobotModel& robot, KnotRange knots, const ToolCurve& curve, double tolerance) {
  const double factor = path_factor(tolerance);
  KnotTerm term = path_term(knots, tolerance);
  term.evaluate = [chain = robot.chain, curve, factor](const Knot& knot, const KnotRows& out) {
    const MotionPoint<Vec3> at = curve(knot.s);
    tool_offset(chain, knot, at.position, factor, out);
    if (out.by_q != nullptr) put(out.by_q, out.columns, chain.n, -factor * at.velocity);
  };
  return term;
}

KnotTerm tool_moves_with_path(const RobotModel& robot, int knot, const Path& path) {
  KnotTerm term = over({knot, knot}, "tool motion", {"vx", "vy", "vz", "ax", "ay", "az"});
  term.on_velocity = term.on_acceleration = term.on_time = true;
  term.lower = term.upper = 0.0;
  term.units = {"m/s", "m/s", "m/s", "m/s^2", "m/s^2", "m/s^2"};
  term.evaluate = [chain = robot.chain, dual = chain_cast<Along>(robot.chain), path](const Knot& at,
                                                                                     const KnotRows& out) {
    const int n = chain.n;
    Jacobian J;
    tool_jacobian(chain, at.poses, J);
    Jacobian J_dot;
    tool_jacobian_derivative(chain, at.poses, J, at.qd, J_dot);
    const MotionPoint<Vec3> wanted = path.at(at.time);
    Eigen::Map<Vec6> value(out.value);
    value << J.topRows<3>() * at.qd - wanted.velocity,
        J.topRows<3>() * at.qdd + J_dot.topRows<3>() * at.qd - wanted.acceleration;
    if (out.by_q == nullptr) return;
    double* acceleration_by_q = out.by_q + 3 * out.columns;
    for (int i = 0; i < n; ++i) {
      // The second derivatives of p are symmetric. Therefore d(J q')/dq = J', and d(J' q')/dq' = 2 J'.
      put(out.by_q, out.columns, i, J_dot.col(i).head<3>());
      put(out.by_qd, out.columns, i, J.col(i).head<3>());
      put(out.by_qd + 3 * out.columns, out.columns, i, 2.0 * J_dot.col(i).head<3>());
      put(out.by_qdd + 3 * out.columns, out.columns, i, J.col(i).head<3>());
    }
    add_acceleration_along_q(dual, at, acceleration_by_q, out.columns);
    // The path's jerk is a central difference of its exact accelerations.
    constexpr double kStep = 1e-4;
    const Vec3 jerk =
        (path.at(at.time + kStep).acceleration - path.at(at.time - kStep).acceleration) / (2.0 * kStep);
    Eigen::Map<Vec6> by_time(out.by_time);
    by_time << -wanted.acceleration, -jerk;
  };
  return term;
}

}  // namespace armtune::internal
