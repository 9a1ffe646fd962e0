#include "tuner/planning/transcription/arm_terms.hpp"

#include <cmath>
#include <memory>

#include "core/common/dual.hpp"
#include "core/robot/chain_cast.hpp"
#include "core/robot/dynamics.hpp"
#include "core/robot/inverse_dynamics_derivatives.hpp"

namespace armtune {
namespace {

KnotTerm over(KnotRange knots, const std::string& name, const std::vector<std::string>& rows) {
  KnotTerm term;
  term.name = name;
  term.rows = rows;
  term.first_knot = knots.first;
  term.last_knot = knots.last;
  return term;
}

std::vector<std::string> units_by_motion(const RobotModel& robot, const char* turning, const char* sliding) {
  std::vector<std::string> units;
  units.reserve(static_cast<std::size_t>(robot.n()));
  for (int i = 0; i < robot.n(); ++i) {
    const bool turns = robot.chain.motion[static_cast<std::size_t>(i)] == JointMotion::kRevolute;
    units.emplace_back(turns ? turning : sliding);
  }
  return units;
}

/// The rows' values are lengths [m] times `factor`.
void in_meters(double factor, KnotTerm& term) {
  term.units.assign(term.rows.size(), "m");
  term.natural = [factor](std::size_t, double value) { return value / factor; };
}

/// z axis and origin of joint i, and whether it turns.
struct JointAxis {
  Vec3 z;
  Vec3 p;
  bool turns;
};

JointAxis axis_of(const Chain& chain, const Poses& poses, int joint) {
  const auto k = static_cast<std::size_t>(joint);
  return {poses.R_0B[k].col(2), poses.p_0B[k], chain.motion[k] == JointMotion::kRevolute};
}

/// d p / d q_i of a point p beyond joint i.
Vec3 point_rate(const JointAxis& axis, const Vec3& p) {
  return axis.turns ? Vec3(axis.z.cross(p - axis.p)) : axis.z;
}

void put(double* rows, int columns, int column, const Vec3& d) {
  for (int i = 0; i < 3; ++i) rows[i * columns + column] = d[i];
}

using Along = Dual<kMaxJoints>;

/// d (J q'' + J' q') / dq, linear part, row by row.
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

/// Tool minus path, times `factor`, with its derivatives.
void tool_offset(const Chain& chain, const Knot& knot, const MotionPoint<Vec3>& path, double factor,
                 const KnotRows& out) {
  Eigen::Map<Vec3> value(out.value);
  value = factor * (knot.poses.p_0T - path.position);
  if (out.by_q == nullptr) return;
  for (int i = 0; i < chain.n; ++i)
    put(out.by_q, out.columns, i, factor * point_rate(axis_of(chain, knot.poses, i), knot.poses.p_0T));
  Eigen::Map<Vec3> by_time(out.by_time);
  by_time = -factor * path.velocity;
}

/// x and y of the unit vector tool to target in the tool frame: zero when tool z points at it.
struct GazeError {
  Eigen::Vector2d value;
  double cosine = 1.0;
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
  out.cosine = R.col(2).dot(u);
  if (!derivatives) return;
  const auto direction_rate = [&](const Vec3& line_rate) {
    return Vec3((line_rate - u * u.dot(line_rate)) / distance);
  };
  for (int i = 0; i < chain.n; ++i) {
    const JointAxis axis = axis_of(chain, knot.poses, i);
    Vec3 rate = direction_rate(-point_rate(axis, knot.poses.p_0T));
    if (axis.turns) rate += u.cross(axis.z);  // R^T turns back as the tool turns
    out.by_q.col(i) = Eigen::Vector2d(R.col(0).dot(rate), R.col(1).dot(rate));
  }
  const Vec3 rate = direction_rate(target.velocity);
  out.by_time = {R.col(0).dot(rate), R.col(1).dot(rate)};
}

}  // namespace

std::vector<std::string> position_units(const RobotModel& robot) {
  return units_by_motion(robot, "rad", "m");
}

KnotTerm torque_limits(const RobotModel& robot, KnotRange knots, double margin) {
  KnotTerm term = over(knots, "torque", joint_names(robot));
  term.on_velocity = term.on_acceleration = true;
  term.lower = -1.0;
  term.upper = 1.0;
  struct Work {
    Chain chain;
    JointVector per;
    JointVector tau;
    InverseDynamicsDerivatives derivatives;
  };
  auto work =
      std::make_shared<Work>(Work{robot.chain, (margin * robot.effort_limits()).cwiseInverse(), {}, {}});
  term.units = units_by_motion(robot, "N m", "N");
  term.natural = [limits = Eigen::VectorXd(margin * robot.effort_limits())](std::size_t row, double value) {
    return limits[static_cast<Eigen::Index>(row)] * value;
  };
  term.evaluate = [work](const Knot& knot, const KnotRows& out) {
    const int n = work->chain.n;
    Eigen::Map<Eigen::VectorXd> value(out.value, n);
    if (out.by_q == nullptr) {
      inverse_dynamics(work->chain, knot.poses, knot.qd, knot.qdd, work->tau);
      value = work->per.cwiseProduct(work->tau);
      return;
    }
    const InverseDynamicsDerivatives& torque = work->derivatives;
    inverse_dynamics_derivatives(work->chain, knot.poses, knot.qd, knot.qdd, work->derivatives);
    value = work->per.cwiseProduct(torque.tau);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        out.by_q[i * out.columns + j] = work->per[i] * torque.by_q(i, j);
        out.by_qd[i * out.columns + j] = work->per[i] * torque.by_qd(i, j);
        out.by_qdd[i * out.columns + j] = work->per[i] * torque.by_qdd(i, j);
      }
    }
  };
  return term;
}

KnotTerm tool_on_path(const RobotModel& robot, KnotRange knots, const HarmonicPath& path, double tolerance) {
  KnotTerm term = over(knots, "tool path", {"x", "y", "z"});
  term.on_time = true;
  term.lower = tolerance > 0.0 ? -1.0 : 0.0;
  term.upper = -term.lower;
  const double factor = tolerance > 0.0 ? 1.0 / tolerance : 1.0;
  in_meters(factor, term);
  term.evaluate = [chain = robot.chain, path, factor](const Knot& knot, const KnotRows& out) {
    tool_offset(chain, knot, path.at(knot.time), factor, out);
  };
  return term;
}

KnotTerm tool_path_cost(const RobotModel& robot, KnotRange knots, const HarmonicPath& path, double weight) {
  KnotTerm term = tool_on_path(robot, knots, path, 1.0 / std::sqrt(weight));
  term.cost = true;
  return term;
}

KnotTerm tool_moves_with_path(const RobotModel& robot, int knot, const HarmonicPath& path) {
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
      // p's second derivatives are symmetric: J q' changes along q as J along q', and J' q' along q' by 2 J'.
      put(out.by_q, out.columns, i, J_dot.col(i).head<3>());
      put(out.by_qd, out.columns, i, J.col(i).head<3>());
      put(out.by_qd + 3 * out.columns, out.columns, i, 2.0 * J_dot.col(i).head<3>());
      put(out.by_qdd + 3 * out.columns, out.columns, i, J.col(i).head<3>());
    }
    add_acceleration_along_q(dual, at, acceleration_by_q, out.columns);
    // The third derivative of a path of harmonics: a difference of its exact accelerations.
    constexpr double kStep = 1e-4;
    const Vec3 jerk =
        (path.at(at.time + kStep).acceleration - path.at(at.time - kStep).acceleration) / (2.0 * kStep);
    Eigen::Map<Vec6> by_time(out.by_time);
    by_time << -wanted.acceleration, -jerk;
  };
  return term;
}

KnotTerm gaze_cost(const RobotModel& robot, KnotRange knots, const HarmonicPath& target, double weight) {
  KnotTerm term = over(knots, "gaze", {"about y", "about x"});
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

KnotTerm gaze_within(const RobotModel& robot, KnotRange knots, const HarmonicPath& target, double angle) {
  KnotTerm term = over(knots, "gaze", {"angle"});
  term.on_time = true;
  term.upper = 1.0;
  const double half = std::sin(0.5 * angle);
  // sin^2(angle/2) = (1 - cos)/2 over its limit: smooth, and it grows up to the target straight behind.
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
    // 1 - cos of a small angle from the difference of the directions, which keeps its digits.
    const Vec3 apart = u - z;
    out.value[0] = factor * 0.5 * apart.squaredNorm();
    if (out.by_q == nullptr) return;
    const auto direction_rate = [&](const Vec3& rate) { return Vec3((rate - u * u.dot(rate)) / distance); };
    for (int j = 0; j < chain.n; ++j) {
      const JointAxis axis = axis_of(chain, knot.poses, j);
      Vec3 rate = direction_rate(-point_rate(axis, knot.poses.p_0T));
      if (axis.turns) rate -= axis.z.cross(z);
      out.by_q[j] = factor * apart.dot(rate);
    }
    out.by_time[0] = factor * apart.dot(direction_rate(at.velocity));
  };
  return term;
}

KnotTerm clear_of(const RobotModel& robot, KnotRange knots, const std::string& name,
                  const HarmonicPath& obstacle, double radius) {
  // The origin of a first joint that turns stands still: nothing can be done about it.
  const int first_joint = robot.chain.motion[0] == JointMotion::kRevolute ? 1 : 0;
  std::vector<std::string> rows = joint_names(robot);
  rows.erase(rows.begin(), rows.begin() + first_joint);
  rows.emplace_back("tool");
  KnotTerm term = over(knots, "distance to " + name, rows);
  in_meters(1.0 / radius, term);
  term.on_time = true;
  term.lower = 1.0;
  term.evaluate = [chain = robot.chain, obstacle, radius, first_joint](const Knot& knot,
                                                                       const KnotRows& out) {
    const MotionPoint<Vec3> at = obstacle.at(knot.time);
    for (int i = first_joint; i <= chain.n; ++i) {  // the tool stands behind the last joint
      const int row = i - first_joint;
      const bool tool = i == chain.n;
      const Vec3 p = tool ? knot.poses.p_0T : knot.poses.p_0B[static_cast<std::size_t>(i)];
      const Vec3 away = p - at.position;
      const double distance = away.norm();
      out.value[row] = distance / radius;
      if (out.by_q == nullptr) continue;
      const Vec3 direction = distance > 0.0 ? Vec3(away / (distance * radius)) : Vec3(Vec3::UnitZ() / radius);
      for (int j = 0; j < i; ++j)
        out.by_q[row * out.columns + j] = direction.dot(point_rate(axis_of(chain, knot.poses, j), p));
      // A sliding joint carries its own origin along.
      if (!tool && chain.motion[static_cast<std::size_t>(i)] == JointMotion::kPrismatic)
        out.by_q[row * out.columns + i] = direction.dot(axis_of(chain, knot.poses, i).z);
      out.by_time[row] = -direction.dot(at.velocity);
    }
  };
  return term;
}

KnotTerm tool_on_curve(const RobotModel& robot, KnotRange knots, const ToolCurve& curve, double tolerance) {
  KnotTerm term = over(knots, "tool path", {"x", "y", "z"});
  term.lower = tolerance > 0.0 ? -1.0 : 0.0;
  term.upper = -term.lower;
  const double factor = tolerance > 0.0 ? 1.0 / tolerance : 1.0;
  in_meters(factor, term);
  term.evaluate = [chain = robot.chain, curve, factor](const Knot& knot, const KnotRows& out) {
    const MotionPoint<Vec3> at = curve(knot.s);
    Eigen::Map<Vec3> value(out.value);
    value = factor * (knot.poses.p_0T - at.position);
    if (out.by_q == nullptr) return;
    for (int i = 0; i < chain.n; ++i)
      put(out.by_q, out.columns, i, factor * point_rate(axis_of(chain, knot.poses, i), knot.poses.p_0T));
    put(out.by_q, out.columns, chain.n, -factor * at.velocity);
  };
  return term;
}

}  // namespace armtune
