// Lays out the program of a trajectory: its unknowns, its rows, and the columns that each row depends on.

#include <algorithm>
#include <cmath>

#include "tuner/planning/transcription/trajectory_program.hpp"

namespace armtune::internal {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
constexpr double kInf = std::numeric_limits<double>::infinity();

}  // namespace

TrajectoryProgram::TrajectoryProgram(TrajectoryTask task) : task_(std::move(task)) {
  std::erase_if(task_.terms,
                [](const KnotTerm& term) { return term.rows.empty(); });  // terms without rows have no effect
  m_ = static_cast<int>(task_.coordinates.size());
  joints_ = task_.chain ? task_.chain->n : m_;
  const int knots = task_.grid.knots();
  int columns = knots * 3 * m_;
  const auto& phases = task_.grid.phases;
  for (const Phase& phase : phases) duration_column_.push_back(phase.free ? columns++ : -1);
  for (int p = 0; p < static_cast<int>(phases.size()); ++p)
    phase_of_interval_.insert(phase_of_interval_.end(),
                              static_cast<std::size_t>(phases[static_cast<std::size_t>(p)].intervals), p);
  cost = VectorXd::Zero(columns);
  metric = VectorXd::Constant(columns, 1.0 / knots);
  for (const int c : duration_column_) {
    if (c < 0) continue;
    cost[c] = task_.duration_cost;
    metric[c] = 1.0;
  }
  lay_out_intervals();
  lay_out_bounds();
  lay_out_terms();
  lay_out_curvature();
  bounds.lower = Eigen::Map<VectorXd>(lower_.data(), static_cast<Index>(lower_.size()));
  bounds.upper = Eigen::Map<VectorXd>(upper_.data(), static_cast<Index>(upper_.size()));
  bounds.penalty = Eigen::Map<VectorXd>(penalty_.data(), static_cast<Index>(penalty_.size()));
}

void TrajectoryProgram::lay_out_intervals() {
  for (int j = 0; j < m_; ++j) {
    const Coordinate& c = task_.coordinates[static_cast<std::size_t>(j)];
    if (std::isfinite(c.jerk)) jerk_limited_.push_back(j);
    if (c.limits_velocity()) velocity_limited_.push_back(j);
    if (c.limits_position()) position_limited_.push_back(j);
  }
  lay_out_continuity();
  lay_out_jerk();
  lay_out_velocity_inside();
  lay_out_position_inside();
  lay_out_smoothness();
}

std::vector<int> TrajectoryProgram::with_duration(std::vector<int> columns, int k) const {
  const int duration =
      duration_column_[static_cast<std::size_t>(phase_of_interval_[static_cast<std::size_t>(k)])];
  if (duration >= 0) columns.push_back(duration);
  return columns;
}

void TrajectoryProgram::lay_out_continuity() {
  groups_.push_back({rows.rows(), "continuity between knots", kDynamics, -1, 2 * m_, 0, 1.0});
  first_dynamics_ = static_cast<int>(rows.blocks().size());
  for (int k = 0; k < task_.grid.intervals(); ++k) {
    for (int j = 0; j < m_; ++j) {
      rows.add(1, with_duration({column(k, 0, j), column(k, 1, j), column(k, 2, j), column(k + 1, 0, j),
                                 column(k + 1, 2, j)},
                                k));
      rows.add(
          1, with_duration({column(k, 1, j), column(k, 2, j), column(k + 1, 1, j), column(k + 1, 2, j)}, k));
      add_bounds(2, 0.0, 0.0, true);
    }
  }
}

void TrajectoryProgram::lay_out_jerk() {
  first_jerk_ = static_cast<int>(rows.blocks().size());
  if (!jerk_limited_.empty())
    groups_.push_back({rows.rows(), "jerk", kJerk, -1, static_cast<int>(jerk_limited_.size()), 3, 1.0});
  for (int k = 0; k < task_.grid.intervals(); ++k) {
    for (const int j : jerk_limited_) {
      rows.add(1, with_duration({column(k, 2, j), column(k + 1, 2, j)}, k));
      add_bounds(1, -1.0, 1.0, false);
    }
  }
}

void TrajectoryProgram::lay_out_velocity_inside() {
  first_inside_ = static_cast<int>(rows.blocks().size());
  if (!velocity_limited_.empty())
    groups_.push_back(
        {rows.rows(), "velocity", kInside, -1, static_cast<int>(velocity_limited_.size()), 1, 1.0});
  for (int k = 0; k < task_.grid.intervals(); ++k) {
    for (const int j : velocity_limited_) {
      const Coordinate& c = task_.coordinates[static_cast<std::size_t>(j)];
      rows.add(1, with_duration({column(k, 1, j), column(k, 2, j)}, k));
      add_bounds(1, c.lowest_velocity() / c.velocity_unit(), c.velocity / c.velocity_unit(), false);
    }
  }
}

void TrajectoryProgram::lay_out_position_inside() {
  first_inside_position_ = static_cast<int>(rows.blocks().size());
  if (!position_limited_.empty())
    groups_.push_back({rows.rows(), "position", kInsidePosition, -1,
                       2 * static_cast<int>(position_limited_.size()), 0, 1.0});
  for (int k = 0; k < task_.grid.intervals(); ++k) {
    for (const int j : position_limited_) {
      const Coordinate& c = task_.coordinates[static_cast<std::size_t>(j)];
      rows.add(1, with_duration({column(k, 0, j), column(k, 1, j)}, k));
      rows.add(1, with_duration({column(k, 0, j), column(k, 1, j), column(k, 2, j)}, k));
      add_bounds(2, c.lower / c.position_unit(), c.upper / c.position_unit(), false);
    }
  }
}

void TrajectoryProgram::lay_out_smoothness() {
  if (!(task_.smoothness.jerk > 0.0 || task_.smoothness.acceleration > 0.0)) return;
  first_smooth_ = static_cast<int>(residuals.blocks().size());
  for (int k = 0; k < task_.grid.intervals(); ++k) {
    for (int j = 0; j < m_; ++j) residuals.add(2, {column(k, 2, j), column(k + 1, 2, j)});
  }
}

void TrajectoryProgram::lay_out_bounds() {
  const auto add = [&](const char* name, int order, int j, double lower, double upper) {
    if (!std::isfinite(lower) && !std::isfinite(upper)) return;
    const double size = unit_of(lower, upper);
    const double per = 1.0 / size;
    groups_.push_back({rows.rows(), name, kBounds, j, 1, order, size});
    std::vector<int> columns;
    columns.reserve(static_cast<std::size_t>(task_.grid.knots()));
    for (int k = 0; k < task_.grid.knots(); ++k) columns.push_back(column(k, order, j));
    const int block = rows.add_diagonal(columns);
    std::fill_n(rows.values(rows.block(block)), columns.size(), scale(order, j) * per);
    add_bounds(static_cast<int>(columns.size()), lower * per, upper * per, false);
  };
  for (int j = 0; j < m_; ++j) {
    const Coordinate& c = task_.coordinates[static_cast<std::size_t>(j)];
    add("position", 0, j, c.lower, c.upper);
    add("velocity", 1, j, c.lowest_velocity(), c.velocity);
    add("acceleration", 2, j, -c.acceleration, c.acceleration);
  }
  for (std::size_t p = 0; p < duration_column_.size(); ++p) {
    if (duration_column_[p] < 0) continue;
    const Phase& phase = task_.grid.phases[p];
    groups_.push_back({rows.rows(), "duration of phase " + phase.name, kBounds, -1, 1, 0, 1.0});
    // Far from a solution, the linearised rows may predict that no time is needed at all.
    halving_rows.push_back(rows.rows());
    const int block = rows.add_diagonal({duration_column_[p]});
    rows.values(rows.block(block))[0] = 1.0;
    add_bounds(1, phase.shortest, phase.longest, true);  // hard: time never runs backwards
  }
}

void TrajectoryProgram::lay_out_terms() {
  for (std::size_t t = 0; t < task_.terms.size(); ++t) {
    const KnotTerm& term = task_.terms[t];
    BlockRows& target = term.cost ? residuals : rows;
    if (!term.cost)
      groups_.push_back(
          {rows.rows(), term.name, kTerm, static_cast<int>(t), static_cast<int>(term.rows.size()), 0, 1.0});
    term_blocks_.push_back({static_cast<int>(target.blocks().size())});
    for (int k = term.first_knot; k <= term.last_knot; ++k) {
      const std::vector<int> columns = knot_columns(k, term.on_velocity, term.on_acceleration, term.on_time);
      target.add(static_cast<int>(term.rows.size()), columns);
      if (!term.cost) add_bounds(static_cast<int>(term.rows.size()), term.lower, term.upper, term.hard);
    }
  }
}

void TrajectoryProgram::add_bounds(int count, double lower, double upper, bool hard) {
  lower_.insert(lower_.end(), static_cast<std::size_t>(count), lower);
  upper_.insert(upper_.end(), static_cast<std::size_t>(count), upper);
  penalty_.insert(penalty_.end(), static_cast<std::size_t>(count), hard ? kInf : task_.penalty);
}

std::vector<int> TrajectoryProgram::free_phases_until(int knot) const {
  std::vector<int> free;
  const int own = knot == 0 ? 0 : phase_of_interval_[static_cast<std::size_t>(knot - 1)];
  for (int p = 0; p <= own; ++p) {
    if (duration_column_[static_cast<std::size_t>(p)] >= 0) free.push_back(p);
  }
  return free;
}

std::vector<int> TrajectoryProgram::knot_columns(int knot, bool on_velocity, bool on_acceleration,
                                                 bool on_time) const {
  std::vector<int> columns;
  for (int j = 0; j < m_; ++j) {
    columns.push_back(column(knot, 0, j));
    if (on_velocity) columns.push_back(column(knot, 1, j));
    if (on_acceleration) columns.push_back(column(knot, 2, j));
  }
  if (on_time) {
    for (const int p : free_phases_until(knot))
      columns.push_back(duration_column_[static_cast<std::size_t>(p)]);
  }
  return columns;
}

}  // namespace armtune::internal
