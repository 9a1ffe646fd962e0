#include "tuner/planning/transcription/trajectory_program.hpp"

#include <algorithm>
#include <cmath>

namespace armtune {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
constexpr double kInf = std::numeric_limits<double>::infinity();
enum GroupKind { kDynamics, kJerk, kBounds, kTerm };

}  // namespace

TrajectoryProgram::TrajectoryProgram(TrajectoryTask task) : task_(std::move(task)) {
  m_ = static_cast<int>(task_.coordinates.size());
  joints_ = task_.chain == nullptr ? m_ : task_.chain->n;
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

int TrajectoryProgram::column(int knot, int order, int coordinate) const {
  return (knot * 3 + order) * m_ + coordinate;
}

double TrajectoryProgram::scale(int order, int coordinate) const {
  const Coordinate& c = task_.coordinates[static_cast<std::size_t>(coordinate)];
  return order == 0 ? 1.0 : order == 1 ? c.velocity_scale : c.acceleration_scale;
}

void TrajectoryProgram::add_bounds(int count, double lower, double upper, bool hard) {
  lower_.insert(lower_.end(), static_cast<std::size_t>(count), lower);
  upper_.insert(upper_.end(), static_cast<std::size_t>(count), upper);
  penalty_.insert(penalty_.end(), static_cast<std::size_t>(count), hard ? kInf : task_.penalty);
}

void TrajectoryProgram::lay_out_intervals() {
  const int intervals = task_.grid.intervals();
  const auto with_duration = [&](std::vector<int> columns, int k) {
    const int duration =
        duration_column_[static_cast<std::size_t>(phase_of_interval_[static_cast<std::size_t>(k)])];
    if (duration >= 0) columns.push_back(duration);
    return columns;
  };
  groups_.push_back({rows.rows(), "dynamics", kDynamics, -1, 0, 2 * m_});
  first_dynamics_ = static_cast<int>(rows.blocks().size());
  for (int k = 0; k < intervals; ++k) {
    for (int j = 0; j < m_; ++j) {
      rows.add(2, with_duration({column(k, 0, j), column(k, 1, j), column(k, 2, j), column(k + 1, 0, j),
                                 column(k + 1, 1, j), column(k + 1, 2, j)},
                                k));
      add_bounds(2, 0.0, 0.0, true);
    }
  }
  has_jerk_limits_ = std::any_of(task_.coordinates.begin(), task_.coordinates.end(),
                                 [](const Coordinate& c) { return std::isfinite(c.jerk); });
  if (has_jerk_limits_) {
    groups_.push_back(
        {rows.rows(), "jerk", kJerk, -1, 0,
         static_cast<int>(std::count_if(task_.coordinates.begin(), task_.coordinates.end(),
                                        [](const Coordinate& c) { return std::isfinite(c.jerk); }))});
    first_jerk_ = static_cast<int>(rows.blocks().size());
    for (int k = 0; k < intervals; ++k) {
      for (int j = 0; j < m_; ++j) {
        if (!std::isfinite(task_.coordinates[static_cast<std::size_t>(j)].jerk)) continue;
        rows.add(1, with_duration({column(k, 2, j), column(k + 1, 2, j)}, k));
        add_bounds(1, -1.0, 1.0, false);
      }
    }
  }
  if (task_.smoothness.jerk > 0.0 || task_.smoothness.acceleration > 0.0) {
    first_smooth_ = static_cast<int>(residuals.blocks().size());
    for (int k = 0; k < intervals; ++k) {
      for (int j = 0; j < m_; ++j) residuals.add(2, {column(k, 2, j), column(k + 1, 2, j)});
    }
  }
}

void TrajectoryProgram::lay_out_bounds() {
  const auto add = [&](const char* name, int order, int j, double lower, double upper) {
    if (!std::isfinite(lower) && !std::isfinite(upper)) return;
    groups_.push_back({rows.rows(), name, kBounds, j, 0, 1});
    // Values relative to the limit, so that a violation is, too.
    const double unit =
        std::max(std::isfinite(lower) ? std::abs(lower) : 0.0, std::isfinite(upper) ? std::abs(upper) : 0.0);
    const double per = unit > 0.0 ? 1.0 / unit : 1.0;
    std::vector<int> columns;
    for (int k = 0; k < task_.grid.knots(); ++k) columns.push_back(column(k, order, j));
    const int block = rows.add_diagonal(columns);
    std::fill_n(rows.values(rows.block(block)), columns.size(), scale(order, j) * per);
    add_bounds(static_cast<int>(columns.size()), lower * per, upper * per, false);
  };
  for (int j = 0; j < m_; ++j) {
    const Coordinate& c = task_.coordinates[static_cast<std::size_t>(j)];
    add("position", 0, j, c.lower, c.upper);
    add("velocity", 1, j, std::max(-c.velocity, c.least_velocity), c.velocity);
    add("acceleration", 2, j, -c.acceleration, c.acceleration);
  }
  for (std::size_t p = 0; p < duration_column_.size(); ++p) {
    if (duration_column_[p] < 0) continue;
    const Phase& phase = task_.grid.phases[p];
    groups_.push_back({rows.rows(), "duration of phase " + phase.name, kBounds, -1, 0, 1});
    const int block = rows.add_diagonal({duration_column_[p]});
    rows.values(rows.block(block))[0] = 1.0;
    add_bounds(1, phase.shortest, phase.longest, false);
  }
}

void TrajectoryProgram::lay_out_terms() {
  for (std::size_t t = 0; t < task_.terms.size(); ++t) {
    const KnotTerm& term = task_.terms[t];
    BlockRows& target = term.cost ? residuals : rows;
    if (!term.cost)
      groups_.push_back({rows.rows(), term.name, kTerm, static_cast<int>(t), term.first_knot,
                         static_cast<int>(term.rows.size())});
    term_blocks_.push_back({static_cast<int>(target.blocks().size())});
    for (int k = term.first_knot; k <= term.last_knot; ++k) {
      const std::vector<int> columns = knot_columns(k, term.on_velocity, term.on_acceleration, term.on_time);
      target.add(static_cast<int>(term.rows.size()), columns);
      if (!term.cost) add_bounds(static_cast<int>(term.rows.size()), term.lower, term.upper, false);
    }
  }
}

std::vector<double> TrajectoryProgram::durations(const VectorXd& z) const {
  std::vector<double> found;
  for (std::size_t p = 0; p < duration_column_.size(); ++p)
    found.push_back(duration_column_[p] >= 0 ? z[duration_column_[p]] : task_.grid.phases[p].duration);
  return found;
}

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
      const RowBlock& block = rows.block(dynamics++);
      row[block.first_row] = q1 - q0 - h * v0 - h * h * (a0 / 3.0 + a1 / 6.0);
      row[block.first_row + 1] = (v1 - v0 - h * (a0 + a1) / 2.0) / sv;
      if (derivatives) {
        double* d = rows.values(block);
        const auto put = [&d](std::initializer_list<double> values) {
          d = std::copy(values.begin(), values.end(), d);
        };
        put({-1.0, -h * sv, -h * h / 3.0 * sa, 1.0, 0.0, -h * h / 6.0 * sa});
        if (free) put({-by_T * (v0 + 2.0 * h * (a0 / 3.0 + a1 / 6.0))});
        put({0.0, -1.0, -h / 2.0 * sa / sv, 0.0, 1.0, -h / 2.0 * sa / sv});
        if (free) put({-by_T * (a0 + a1) / 2.0 / sv});
      }
      const double limit = task_.coordinates[static_cast<std::size_t>(j)].jerk;
      if (has_jerk_limits_ && std::isfinite(limit)) {
        const RowBlock& jerk_block = rows.block(jerk++);
        const double per = 1.0 / (h * limit);
        row[jerk_block.first_row] = (a1 - a0) * per;
        if (derivatives) {
          double* d = rows.values(jerk_block);
          d[0] = -sa * per;
          d[1] = sa * per;
          if (free) d[2] = -(a1 - a0) * per / h * by_T;
        }
      }
      if (first_smooth_ >= 0) {
        // Exact for an acceleration that is linear between knots:
        // integral of a^2 = h ((a0 + a1)/2)^2 + h/12 (a1 - a0)^2, of the jerk's square (a1 - a0)^2/h.
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

double TrajectoryProgram::part_of_phase(int knot, std::size_t phase) const {
  const int within = knot - task_.grid.first_knot(static_cast<int>(phase));
  return std::clamp(static_cast<double>(within) / task_.grid.phases[phase].intervals, 0.0, 1.0);
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
  if (task_.chain != nullptr) forward_kinematics(*task_.chain, knot.q, knot.poses);
  return knot;
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
  double* d = derivative;
  for (Index i = 0; i < count; ++i) {
    for (int j = 0; j < m_; ++j) *d++ = scratch_q_[i * m_ + j];
    if (term.on_velocity) {
      for (int j = 0; j < m_; ++j) *d++ = scratch_qd_[i * m_ + j] * scale(1, j);
    }
    if (term.on_acceleration) {
      for (int j = 0; j < m_; ++j) *d++ = scratch_qdd_[i * m_ + j] * scale(2, j);
    }
    if (term.on_time) {
      for (const int p : free_phases_until(knot.index))
        *d++ = scratch_time_[i] * part_of_phase(knot.index, static_cast<std::size_t>(p));
    }
  }
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
  for (int order = 0; order < 3; ++order) {
    if ((order == 1 && !on_velocity) || (order == 2 && !on_acceleration)) continue;
    for (int j = 0; j < m_; ++j) columns.push_back(column(knot, order, j));
  }
  if (on_time) {
    for (const int p : free_phases_until(knot))
      columns.push_back(duration_column_[static_cast<std::size_t>(p)]);
  }
  return columns;
}

VectorXd TrajectoryProgram::unknowns(const Trajectory& trajectory) const {
  VectorXd z(variables());
  for (int k = 0; k < task_.grid.knots(); ++k) {
    for (int j = 0; j < m_; ++j) {
      z[column(k, 0, j)] = trajectory.position(j, k);
      z[column(k, 1, j)] = trajectory.velocity(j, k) / scale(1, j);
      z[column(k, 2, j)] = trajectory.acceleration(j, k) / scale(2, j);
    }
  }
  for (std::size_t p = 0; p < duration_column_.size(); ++p) {
    if (duration_column_[p] >= 0) z[duration_column_[p]] = trajectory.durations[p];
  }
  return z;
}

Trajectory TrajectoryProgram::trajectory(const VectorXd& z) const {
  Trajectory found;
  found.durations = durations(z);
  const int knots = task_.grid.knots();
  found.position.resize(m_, knots);
  found.velocity.resize(m_, knots);
  found.acceleration.resize(m_, knots);
  found.time.reserve(static_cast<std::size_t>(knots));
  found.time.push_back(task_.grid.start);
  double phase_start = task_.grid.start;
  for (std::size_t p = 0; p < found.durations.size(); ++p) {
    const int intervals = task_.grid.phases[p].intervals;
    for (int i = 1; i <= intervals; ++i)
      found.time.push_back(phase_start + found.durations[p] * i / intervals);
    phase_start += found.durations[p];
  }
  for (int k = 0; k < knots; ++k) {
    for (int j = 0; j < m_; ++j) {
      found.position(j, k) = z[column(k, 0, j)];
      found.velocity(j, k) = z[column(k, 1, j)] * scale(1, j);
      found.acceleration(j, k) = z[column(k, 2, j)] * scale(2, j);
    }
  }
  return found;
}

VectorXd TrajectoryProgram::multipliers_from(const TrajectoryProgram& coarse, const VectorXd& y) const {
  VectorXd fine = VectorXd::Zero(rows.rows());
  const int intervals = task_.grid.intervals();
  const int coarse_intervals = coarse.task_.grid.intervals();
  const auto end_of = [](const TrajectoryProgram& program, std::size_t g) {
    return g + 1 < program.groups_.size() ? program.groups_[g + 1].first_row
                                          : static_cast<Index>(program.rows.rows());
  };
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const RowGroup& to = groups_[g];
    const RowGroup& from = coarse.groups_[g];
    const Index count = (end_of(*this, g) - to.first_row) / to.width;
    const Index coarse_count = (end_of(coarse, g) - from.first_row) / from.width;
    // What acts on many knots acts with a density in time; costates and what acts at one knot have none.
    const double density = to.kind == kDynamics || count == 1
                               ? 1.0
                               : static_cast<double>(coarse_intervals) / static_cast<double>(intervals);
    for (Index k = 0; k < count; ++k) {
      const Index source = count == 1 ? 0 : (k * (coarse_count - 1) + (count - 1) / 2) / (count - 1);
      for (int i = 0; i < to.width; ++i)
        fine[to.first_row + k * to.width + i] = density * y[from.first_row + source * from.width + i];
    }
  }
  return fine;
}

RowMeaning TrajectoryProgram::meaning(Index row) const {
  auto group = std::upper_bound(groups_.begin(), groups_.end(), row,
                                [](Index value, const RowGroup& g) { return value < g.first_row; });
  --group;
  const auto offset = static_cast<int>(row - group->first_row);
  RowMeaning meaning;
  meaning.limit = group->limit;
  switch (group->kind) {
    case kDynamics:
      meaning.part = task_.coordinates[static_cast<std::size_t>(offset / 2 % m_)].name;
      meaning.knot = offset / 2 / m_;
      break;
    case kJerk: {
      std::vector<int> limited;
      for (int j = 0; j < m_; ++j) {
        if (std::isfinite(task_.coordinates[static_cast<std::size_t>(j)].jerk)) limited.push_back(j);
      }
      const int count = static_cast<int>(limited.size());
      meaning.part =
          task_.coordinates[static_cast<std::size_t>(limited[static_cast<std::size_t>(offset % count)])].name;
      meaning.knot = offset / count;
      break;
    }
    case kBounds:
      if (group->term >= 0) meaning.part = task_.coordinates[static_cast<std::size_t>(group->term)].name;
      meaning.knot = group->term >= 0 ? offset : 0;
      break;
    default: {
      const KnotTerm& term = task_.terms[static_cast<std::size_t>(group->term)];
      const int count = static_cast<int>(term.rows.size());
      meaning.part = term.rows[static_cast<std::size_t>(offset % count)];
      meaning.knot = term.first_knot + offset / count;
      break;
    }
  }
  return meaning;
}

}  // namespace armtune
