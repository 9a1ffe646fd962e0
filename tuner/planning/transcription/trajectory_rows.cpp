// Computes values and derivatives of the rows and residuals at given unknowns.

#include <cmath>

#include "tuner/planning/transcription/trajectory_program.hpp"

namespace armtune::internal {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Receives the values of rows, and also their derivatives if `derivatives` is true.
struct RowTarget {
  BlockRows& rows;
  VectorXd& values;
  bool derivatives;
};

/// The motion of one coordinate between two knots, the first (0) and the second (1).
struct IntervalMotion {
  double h = 0.0;             ///< time between the knots [s]
  double by_T = 0.0;          ///< derivative of h with respect to the duration of its phase
  bool free = false;          ///< true if that duration is an unknown
  double sv = 1.0, sa = 1.0;  ///< units of the unknowns of velocity and acceleration
  double q0 = 0.0, v0 = 0.0, a0 = 0.0;
  double q1 = 0.0, v1 = 0.0, a1 = 0.0;

  /// Writes block `first`, the continuity of the position, and the next one, that of the velocity.
  void write_continuity(int first, const RowTarget& target) const {
    const RowBlock& position = target.rows.block(first);
    const RowBlock& velocity = target.rows.block(first + 1);
    target.values[position.first_row] = q1 - q0 - h * v0 - h * h * (a0 / 3.0 + a1 / 6.0);
    target.values[velocity.first_row] = (v1 - v0 - h * (a0 + a1) / 2.0) / sv;
    if (!target.derivatives) return;
    double* d = target.rows.values(position);
    d[0] = -1.0;
    d[1] = -h * sv;
    d[2] = -h * h / 3.0 * sa;
    d[3] = 1.0;
    d[4] = -h * h / 6.0 * sa;
    if (free) d[5] = -by_T * (v0 + 2.0 * h * (a0 / 3.0 + a1 / 6.0));
    d = target.rows.values(velocity);
    d[0] = -1.0;
    d[1] = -h / 2.0 * sa / sv;
    d[2] = 1.0;
    d[3] = -h / 2.0 * sa / sv;
    if (free) d[4] = -by_T * (a0 + a1) / 2.0 / sv;
  }

  /// Writes the jerk relative to its limit.
  void write_jerk(double limit, int block, const RowTarget& target) const {
    const RowBlock& jerk = target.rows.block(block);
    const double per = 1.0 / (h * limit);
    target.values[jerk.first_row] = (a1 - a0) * per;
    if (!target.derivatives) return;
    double* d = target.rows.values(jerk);
    d[0] = -sa * per;
    d[1] = sa * per;
    if (free) d[2] = -(a1 - a0) * per / h * by_T;
  }

  /// Writes the control point of the velocity between the knots, relative to `unit`.
  void write_velocity_inside(double unit, int block, const RowTarget& target) const {
    const RowBlock& inside = target.rows.block(block);
    const double per = 1.0 / unit;
    target.values[inside.first_row] = (v0 + h * a0 / 2.0) * per;
    if (!target.derivatives) return;
    double* d = target.rows.values(inside);
    d[0] = sv * per;
    d[1] = h / 2.0 * sa * per;
    if (free) d[2] = by_T * a0 / 2.0 * per;
  }

  /// Writes the two control points of the position between the knots, relative to `unit`, to block `first`
  /// and the next one.
  void write_position_inside(double unit, int first, const RowTarget& target) const {
    const RowBlock& early = target.rows.block(first);
    const RowBlock& late = target.rows.block(first + 1);
    const double per = 1.0 / unit;
    target.values[early.first_row] = (q0 + h * v0 / 3.0) * per;
    target.values[late.first_row] = (q0 + h * (2.0 * v0 / 3.0 + h * a0 / 6.0)) * per;
    if (!target.derivatives) return;
    double* d = target.rows.values(early);
    d[0] = per;
    d[1] = h / 3.0 * sv * per;
    if (free) d[2] = by_T * v0 / 3.0 * per;
    d = target.rows.values(late);
    d[0] = per;
    d[1] = 2.0 * h / 3.0 * sv * per;
    d[2] = h * h / 6.0 * sa * per;
    if (free) d[3] = by_T * (2.0 * v0 / 3.0 + h * a0 / 3.0) * per;
  }

  /// Writes the costs of acceleration and jerk. nominal: time between the knots in the first guess [s].
  void write_smoothness(const Smoothness& smoothness, double nominal, int block,
                        const RowTarget& target) const {
    // These integrals are exact, because the acceleration is linear between knots: that of a^2 is
    // h ((a0 + a1)/2)^2 + h/12 (a1 - a0)^2, and that of jerk^2 is (a1 - a0)^2/h.
    const RowBlock& smooth = target.rows.block(block);
    const double mean = std::sqrt(smoothness.acceleration * nominal) / 2.0;
    const double change = std::sqrt(smoothness.acceleration * nominal / 12.0 + smoothness.jerk / nominal);
    target.values[smooth.first_row] = mean * (a0 + a1) / sa;
    target.values[smooth.first_row + 1] = change * (a1 - a0) / sa;
    if (!target.derivatives) return;
    double* d = target.rows.values(smooth);
    d[0] = d[1] = mean;
    d[2] = -change;
    d[3] = change;
  }
};

}  // namespace

void TrajectoryProgram::evaluate(const VectorXd& z, VectorXd& residual, VectorXd& row) {
  residual.resize(residuals.rows());
  row.resize(rows.rows());
  intervals_at(z, residual, row, false);
  knots_at(z, residual, row, false);
}

void TrajectoryProgram::linearize(const VectorXd& z, VectorXd& residual, VectorXd& row) {
  residual.resize(residuals.rows());
  row.resize(rows.rows());
  intervals_at(z, residual, row, true);
  knots_at(z, residual, row, true);
}

void TrajectoryProgram::intervals_at(const VectorXd& z, VectorXd& residual, VectorXd& row, bool derivatives) {
  const std::vector<double> T = durations(z);
  const int intervals = task_.grid.intervals();
  const RowTarget constraints{rows, row, derivatives};
  const RowTarget costs{residuals, residual, derivatives};
  int dynamics = first_dynamics_;
  int jerk = first_jerk_;
  int inside = first_inside_;
  int inside_position = first_inside_position_;
  for (int k = 0; k < intervals; ++k) {
    const auto phase = static_cast<std::size_t>(phase_of_interval_[static_cast<std::size_t>(k)]);
    IntervalMotion motion;
    motion.by_T = 1.0 / task_.grid.phases[phase].intervals;
    motion.h = T[phase] * motion.by_T;
    motion.free = duration_column_[phase] >= 0;
    const double nominal = task_.grid.phases[phase].duration * motion.by_T;
    for (int j = 0; j < m_; ++j) {
      motion.sv = scale(1, j);
      motion.sa = scale(2, j);
      motion.q0 = z[column(k, 0, j)];
      motion.v0 = z[column(k, 1, j)] * motion.sv;
      motion.a0 = z[column(k, 2, j)] * motion.sa;
      motion.q1 = z[column(k + 1, 0, j)];
      motion.v1 = z[column(k + 1, 1, j)] * motion.sv;
      motion.a1 = z[column(k + 1, 2, j)] * motion.sa;
      motion.write_continuity(dynamics, constraints);
      dynamics += 2;
      const Coordinate& coordinate = task_.coordinates[static_cast<std::size_t>(j)];
      if (std::isfinite(coordinate.jerk)) motion.write_jerk(coordinate.jerk, jerk++, constraints);
      if (coordinate.limits_velocity())
        motion.write_velocity_inside(coordinate.velocity_unit(), inside++, constraints);
      if (coordinate.limits_position()) {
        motion.write_position_inside(coordinate.position_unit(), inside_position, constraints);
        inside_position += 2;
      }
      if (first_smooth_ >= 0)
        motion.write_smoothness(task_.smoothness, nominal, first_smooth_ + k * m_ + j, costs);
    }
  }
}

void TrajectoryProgram::knots_at(const VectorXd& z, VectorXd& residual, VectorXd& row, bool derivatives) {
  for (const RowBlock& block : rows.blocks()) {
    if (!block.diagonal) continue;
    const int* columns = rows.columns(block);
    const double* d = rows.values(block);
    for (int i = 0; i < block.rows; ++i) row[block.first_row + i] = d[i] * z[columns[i]];
  }
  if (task_.terms.empty()) return;
  const std::vector<double> T = durations(z);
  for (int k = 0; k < task_.grid.knots(); ++k) {
    const Knot knot = knot_at(z, T, k);
    for (std::size_t t = 0; t < task_.terms.size(); ++t) {
      const KnotTerm& term = task_.terms[t];
      if (k < term.first_knot || k > term.last_knot) continue;
      write_term(t, knot, term.cost ? residual : row, term.cost ? residuals : rows, derivatives);
    }
  }
}

void TrajectoryProgram::write_term(std::size_t t, const Knot& knot, VectorXd& values, BlockRows& target,
                                   bool derivatives) {
  const RowBlock& block = target.block(term_blocks_[t].first_block + knot.index - task_.terms[t].first_knot);
  term_rows(task_.terms[t], knot, values.data() + block.first_row,
            derivatives ? target.values(block) : nullptr);
}

void TrajectoryProgram::term_rows(const KnotTerm& term, const Knot& knot, double* value, double* derivative) {
  const auto count = static_cast<Index>(term.rows.size());
  KnotRows out;
  out.value = value;
  out.columns = m_;
  if (derivative != nullptr) {
    scratch_q_.setZero(count * m_);
    scratch_qd_.setZero(count * m_);
    scratch_qdd_.setZero(count * m_);
    scratch_time_.setZero(count);
    out.by_q = scratch_q_.data();
    out.by_qd = scratch_qd_.data();
    out.by_qdd = scratch_qdd_.data();
    out.by_time = scratch_time_.data();
  }
  term.evaluate(knot, out);
  if (derivative == nullptr) return;
  const std::vector<int> free = term.on_time ? free_phases_until(knot.index) : std::vector<int>();
  double* d = derivative;
  for (Index i = 0; i < count; ++i) {
    for (int j = 0; j < m_; ++j) {
      *d++ = scratch_q_[i * m_ + j];
      if (term.on_velocity) *d++ = scratch_qd_[i * m_ + j] * scale(1, j);
      if (term.on_acceleration) *d++ = scratch_qdd_[i * m_ + j] * scale(2, j);
    }
    for (const int p : free) *d++ = scratch_time_[i] * part_of_phase(knot.index, static_cast<std::size_t>(p));
  }
}

Knot TrajectoryProgram::knot_at(const VectorXd& z, const std::vector<double>& durations, int k) const {
  Knot knot;
  knot.index = k;
  knot.time = task_.grid.start;
  for (std::size_t p = 0; p < durations.size(); ++p) knot.time += durations[p] * part_of_phase(k, p);
  knot.q.resize(joints_);
  knot.qd.resize(joints_);
  knot.qdd.resize(joints_);
  for (int j = 0; j < joints_; ++j) {
    knot.q[j] = z[column(k, 0, j)];
    knot.qd[j] = z[column(k, 1, j)] * scale(1, j);
    knot.qdd[j] = z[column(k, 2, j)] * scale(2, j);
  }
  if (m_ > joints_) {
    knot.s = z[column(k, 0, joints_)];
    knot.sd = z[column(k, 1, joints_)] * scale(1, joints_);
    knot.sdd = z[column(k, 2, joints_)] * scale(2, joints_);
  }
  if (task_.chain) forward_kinematics(*task_.chain, knot.q, knot.poses);
  return knot;
}

}  // namespace armtune::internal
