// Computes the second derivatives (curvature) of rows and residuals. Those of the rows between knots are
// zero unless the duration is free, and are exact. Those of the terms at knots are differences of exact first
// derivatives. They are computed only if a multiplier of the term is not zero.

#include <algorithm>
#include <cmath>

#include "tuner/planning/transcription/trajectory_program.hpp"

namespace armtune::internal {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kDifference = 1e-6;
constexpr double kNoMultiplier = 1e-12;

}  // namespace

void TrajectoryProgram::lay_out_curvature() {
  const int intervals = task_.grid.intervals();
  interval_curvature_.assign(static_cast<std::size_t>(intervals), -1);
  for (int k = 0; k < intervals; ++k) {
    const int duration =
        duration_column_[static_cast<std::size_t>(phase_of_interval_[static_cast<std::size_t>(k)])];
    if (duration < 0) continue;
    for (int j = 0; j < m_; ++j) {
      const int block = curvature.add({column(k, 1, j), column(k, 2, j), column(k + 1, 2, j), duration});
      if (j == 0) interval_curvature_[static_cast<std::size_t>(k)] = block;
    }
  }
  const int knots = task_.grid.knots();
  knot_curvature_.assign(static_cast<std::size_t>(knots), -1);
  for (int k = 0; k < knots; ++k) {
    bool any = false, velocity = false, acceleration = false, time = false;
    for (const KnotTerm& term : task_.terms) {
      if (term.linear || k < term.first_knot || k > term.last_knot) continue;
      any = true;
      velocity = velocity || term.on_velocity;
      acceleration = acceleration || term.on_acceleration;
      time = time || term.on_time;
    }
    if (any)
      knot_curvature_[static_cast<std::size_t>(k)] =
          curvature.add(knot_columns(k, velocity, acceleration, time));
  }
}

void TrajectoryProgram::curve(const VectorXd& z, const VectorXd& residual, const VectorXd& y) {
  curvature.set_zero();
  curve_intervals(z, y);
  curve_knots(z, residual, y);
}

void TrajectoryProgram::curve_intervals(const VectorXd& z, const VectorXd& y) {
  const std::vector<double> T = durations(z);
  int dynamics = first_dynamics_;
  int jerk = first_jerk_;
  int inside = first_inside_;
  int inside_position = first_inside_position_;
  for (int k = 0; k < task_.grid.intervals(); ++k) {
    const auto phase = static_cast<std::size_t>(phase_of_interval_[static_cast<std::size_t>(k)]);
    const int first = interval_curvature_[static_cast<std::size_t>(k)];
    const double by_T = 1.0 / task_.grid.phases[phase].intervals;
    const double h = T[phase] * by_T;
    for (int j = 0; j < m_; ++j) {
      const double y_q = y[rows.block(dynamics++).first_row];
      const double y_v = y[rows.block(dynamics++).first_row];
      const Coordinate& coordinate = task_.coordinates[static_cast<std::size_t>(j)];
      const double limit = coordinate.jerk;
      const bool jerk_row = std::isfinite(limit);
      const double y_jerk = jerk_row ? y[rows.block(jerk++).first_row] : 0.0;
      const double y_inside = coordinate.limits_velocity() ? y[rows.block(inside++).first_row] : 0.0;
      // Multipliers of the two control points of the position, divided by their unit.
      double y_early = 0.0, y_late = 0.0;
      if (coordinate.limits_position()) {
        y_early = y[rows.block(inside_position++).first_row] / coordinate.position_unit();
        y_late = y[rows.block(inside_position++).first_row] / coordinate.position_unit();
      }
      if (first < 0) continue;
      const double sv = scale(1, j);
      const double sa = scale(2, j);
      const double a0 = z[column(k, 2, j)] * sa;
      const double a1 = z[column(k + 1, 2, j)] * sa;
      auto C = curvature.values(first + j);  // with respect to v0, a0, a1, T
      double by_a0 = -y_q * 2.0 * h / 3.0 - y_v / (2.0 * sv) + y_inside / (2.0 * coordinate.velocity_unit());
      double by_a1 = -y_q * 2.0 * h / 6.0 - y_v / (2.0 * sv);
      double by_h = -y_q * 2.0 * (a0 / 3.0 + a1 / 6.0);
      if (jerk_row) {
        by_a0 += y_jerk / (h * h * limit);
        by_a1 -= y_jerk / (h * h * limit);
        by_h += y_jerk * 2.0 * (a1 - a0) / (h * h * h * limit);
      }
      by_a0 += y_late * h / 3.0;
      by_h += y_late * a0 / 3.0;
      C(0, 3) = C(3, 0) = (-y_q + y_early / 3.0 + y_late * 2.0 / 3.0) * sv * by_T;
      C(1, 3) = C(3, 1) = by_a0 * sa * by_T;
      C(2, 3) = C(3, 2) = by_a1 * sa * by_T;
      C(3, 3) = by_h * by_T * by_T;
    }
  }
}

void TrajectoryProgram::curve_knots(const VectorXd& z, const VectorXd& residual, const VectorXd& y) {
  VectorXd at = z;
  VectorXd value, derivative, here, there;
  for (int k = 0; k < task_.grid.knots(); ++k) {
    const int index = knot_curvature_[static_cast<std::size_t>(k)];
    if (index < 0) continue;
    std::vector<std::size_t> counting;
    for (std::size_t t = 0; t < task_.terms.size(); ++t) {
      const KnotTerm& term = task_.terms[t];
      if (term.linear || k < term.first_knot || k > term.last_knot) continue;
      const RowBlock& block =
          (term.cost ? residuals : rows).block(term_blocks_[t].first_block + k - term.first_knot);
      const VectorXd& weights = term.cost ? residual : y;
      if (weights.segment(block.first_row, block.rows).lpNorm<Eigen::Infinity>() > kNoMultiplier)
        counting.push_back(t);
    }
    if (counting.empty()) continue;
    const auto& block = curvature.blocks()[static_cast<std::size_t>(index)];
    const int* columns = curvature.columns(block);
    auto C = curvature.values(index);
    // Computes the gradient of residual^T r + y^T c with respect to the block's columns.
    const auto gradient = [&](VectorXd& g) {
      g.setZero(block.columns);
      const Knot knot = knot_at(at, durations(at), k);
      for (const std::size_t t : counting) {
        const KnotTerm& term = task_.terms[t];
        const BlockRows& of = term.cost ? residuals : rows;
        const VectorXd& weights = term.cost ? residual : y;
        const RowBlock& term_block = of.block(term_blocks_[t].first_block + k - term.first_knot);
        value.resize(term_block.rows);
        derivative.resize(static_cast<Index>(term_block.rows) * term_block.columns);
        term_rows(term, knot, value.data(), derivative.data());
        const int* own = of.columns(term_block);
        for (int c = 0, b = 0; c < term_block.columns; ++c) {
          while (columns[b] != own[c]) ++b;
          for (int i = 0; i < term_block.rows; ++i)
            g[b] += weights[term_block.first_row + i] *
                    derivative[static_cast<Index>(i) * term_block.columns + c];
        }
      }
    };
    gradient(here);
    for (int b = 0; b < block.columns; ++b) {
      if (is_acceleration(columns[b])) continue;  // every term is linear in accelerations
      const double kept = at[columns[b]];
      at[columns[b]] = kept + kDifference;
      gradient(there);
      at[columns[b]] = kept;
      C.col(b) = (there - here) / kDifference;
    }
    for (int b = 0; b < block.columns; ++b) {
      if (is_acceleration(columns[b])) C.col(b) = C.row(b).transpose();
    }
    for (int b = 0; b < block.columns; ++b) {
      for (int c = 0; c < b; ++c) C(b, c) = C(c, b) = 0.5 * (C(b, c) + C(c, b));
    }
  }
}

}  // namespace armtune::internal
