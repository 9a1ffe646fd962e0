// Computes values and derivatives of the rows and residuals at given unknowns.

#include <algorithm>
#include <cmath>

#include "tuner/planning/transcription/trajectory_program.hpp"

namespace armtune::internal {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

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
  int dynamics = first_dynamics_;
  int jerk = first_jerk_;
  int inside = first_inside_;
  int inside_position = first_inside_position_;
  for (int k = 0; k < intervals; ++k) {
    const auto phase = static_cast<std::size_t>(phase_of_interval_[static_cast<std::size_t>(k)]);
    const double by_T = 1.0 / task_.grid.phases[phase].intervals;
    const double h = T[phase] * by_T;
    const bool free = duration_column_[phase] >= 0;
    const double nominal = task_.grid.phases[phase].duration * by_T;
    for (int j = 0; j < m_; ++j) {
      const double sv = scale(1, j);
      const double sa = scale(2, j);
      const double q0 = z[column(k, 0, j)], v0 = z[column(k, 1, j)] * sv, a0 = z[column(k, 2, j)] * sa;
      const double q1 = z[column(k + 1, 0, j)], v1 = z[column(k + 1, 1, j)] * sv,
                   a1 = z[column(k + 1, 2, j)] * sa;
      const RowBlock& position = rows.block(dynamics++);
      const RowBlock& velocity = rows.block(dynamics++);
      row[position.first_row] = q1 - q0 - h * v0 - h * h * (a0 / 3.0 + a1 / 6.0);
      row[velocity.first_row] = (v1 - v0 - h * (a0 + a1) / 2.0) / sv;
      if (derivatives) {
        const auto put = [&](const RowBlock& block, std::initializer_list<double> values,
                             double by_duration) {
          double* end = std::copy(values.begin(), values.end(), rows.values(block));
          if (free) *end = by_duration;
        };
        put(position, {-1.0, -h * sv, -h * h / 3.0 * sa, 1.0, -h * h / 6.0 * sa},
            -by_T * (v0 + 2.0 * h * (a0 / 3.0 + a1 / 6.0)));
        put(velocity, {-1.0, -h / 2.0 * sa / sv, 1.0, -h / 2.0 * sa / sv}, -by_T * (a0 + a1) / 2.0 / sv);
      }
      const Coordinate& coordinate = task_.coordinates[static_cast<std::size_t>(j)];
      if (std::isfinite(coordinate.jerk)) {
        const RowBlock& jerk_block = rows.block(jerk++);
        const double per = 1.0 / (h * coordinate.jerk);
        row[jerk_block.first_row] = (a1 - a0) * per;
        if (derivatives) {
          double* d = rows.values(jerk_block);
          d[0] = -sa * per;
          d[1] = sa * per;
          if (free) d[2] = -(a1 - a0) * per / h * by_T;
        }
      }
      if (coordinate.limits_velocity()) {
        const RowBlock& inside_block = rows.block(inside++);
        const double per = 1.0 / coordinate.velocity_unit();
        row[inside_block.first_row] = (v0 + h * a0 / 2.0) * per;
        if (derivatives) {
          double* d = rows.values(inside_block);
          d[0] = sv * per;
          d[1] = h / 2.0 * sa * per;
          if (free) d[2] = by_T * a0 / 2.0 * per;
        }
      }
      if (coordinate.limits_position()) {
        const RowBlock& early = rows.block(inside_position++);
        const RowBlock& late = rows.block(inside_position++);
        const double per = 1.0 / coordinate.position_unit();
        row[early.first_row] = (q0 + h * v0 / 3.0) * per;
        row[late.first_row] = (q0 + h * (2.0 * v0 / 3.0 + h * a0 / 6.0)) * per;
        if (derivatives) {
          double* d = rows.values(early);
          d[0] = per;
          d[1] = h / 3.0 * sv * per;
          if (free) d[2] = by_T * v0 / 3.0 * per;
          d = rows.values(late);
          d[0] = per;
          d[1] = 2.0 * h / 3.0 * sv * per;
          d[2] = h * h / 6.0 * sa * per;
          if (free) d[3] = by_T * (2.0 * v0 / 3.0 + h * a0 / 3.0) * per;
        }
      }
      if (first_smooth_ >= 0) {
        // These integrals are exact, because the acceleration is linear between knots: that of a^2 is
        // h ((a0 + a1)/2)^2 + h/12 (a1 - a0)^2, and that of jerk^2 is (a1 - a0)^2/h.
        const RowBlock& smooth = residuals.block(first_smooth_ + k * m_ + j);
        const double mean = std::sqrt(task_.smoothness.acceleration * nominal) / 2.0;
        const double change =
            std::sqrt(task_.smoothness.acceleration * nominal / 12.0 + task_.smoothness.jerk / nominal);
        residual[smooth.first_row] = mean * (a0 + a1) / sa;
        residual[smooth.first_row + 1] = change * (a1 - a0) / sa;
        if (derivatives) {
          double* d = residuals.values(smooth);
          d[0] = d[1] = mean;
          d[2] = -change;
          d[3] = change;
        }
      }
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
