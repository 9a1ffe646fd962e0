#include "tuner/planning/transcription/trajectory_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

}  // namespace

int TrajectoryProgram::column(int knot, int order, int coordinate) const {
  return (knot * m_ + coordinate) * 3 + order;
}

double TrajectoryProgram::objective(const VectorXd& z) {
  VectorXd residual, row;
  evaluate(z, residual, row);
  return cost.dot(z) + 0.5 * residual.squaredNorm();
}

double TrajectoryProgram::scale(int order, int coordinate) const {
  const Coordinate& c = task_.coordinates[static_cast<std::size_t>(coordinate)];
  return order == 0 ? 1.0 : order == 1 ? c.velocity_scale : c.acceleration_scale;
}

std::vector<double> TrajectoryProgram::durations(const VectorXd& z) const {
  std::vector<double> found;
  for (std::size_t p = 0; p < duration_column_.size(); ++p)
    found.push_back(duration_column_[p] >= 0 ? z[duration_column_[p]] : task_.grid.phases[p].duration);
  return found;
}

double TrajectoryProgram::part_of_phase(int knot, std::size_t phase) const {
  const int within = knot - task_.grid.first_knot(static_cast<int>(phase));
  return std::clamp(static_cast<double>(within) / task_.grid.phases[phase].intervals, 0.0, 1.0);
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
    // The multipliers of a limit at many knots approximate a density in time, so they shrink with the
    // interval. Those of the dynamics (costates), and of a limit at one knot, do not.
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

const TrajectoryProgram::RowGroup& TrajectoryProgram::group_of(Index row) const {
  const auto after = std::upper_bound(groups_.begin(), groups_.end(), row,
                                      [](Index value, const RowGroup& g) { return value < g.first_row; });
  return *std::prev(after);
}

RowMeaning TrajectoryProgram::meaning(Index row) const {
  const RowGroup& group = group_of(row);
  const auto offset = static_cast<int>(row - group.first_row);
  RowMeaning meaning;
  meaning.limit = group.limit;
  const auto of_coordinate = [&](const Coordinate& c, int order) {
    meaning.part = c.name;
    meaning.unit = c.unit + (order == 0 ? "" : order == 1 ? "/s" : fmt::format("/s^{}", order));
  };
  switch (group.kind) {
    case kDynamics:
      of_coordinate(task_.coordinates[static_cast<std::size_t>(offset / 2 % m_)], offset % 2);
      meaning.knot = offset / 2 / m_;
      break;
    case kJerk:
    case kInside:
    case kInsidePosition:
      of_coordinate(limited_at(group, offset), group.order);
      meaning.knot = offset / group.width;
      break;
    case kBounds:
      if (group.term >= 0) {
        of_coordinate(task_.coordinates[static_cast<std::size_t>(group.term)], group.order);
        meaning.knot = offset;
      } else {
        meaning.unit = "s";
      }
      break;
    default: {
      const KnotTerm& term = task_.terms[static_cast<std::size_t>(group.term)];
      const auto part = static_cast<std::size_t>(offset % group.width);
      meaning.part = term.rows[part];
      if (!term.units.empty()) meaning.unit = term.units[part];
      meaning.knot = term.first_knot + offset / group.width;
      break;
    }
  }
  return meaning;
}

double TrajectoryProgram::natural(Index row, double value) const {
  const RowGroup& group = group_of(row);
  const auto offset = static_cast<int>(row - group.first_row);
  switch (group.kind) {
    case kDynamics:
      return offset % 2 == 0 ? value : value * scale(1, offset / 2 % m_);
    case kJerk:
      return value * limited_at(group, offset).jerk;
    case kInside:
      return value * limited_at(group, offset).velocity_unit();
    case kInsidePosition:
      return value * limited_at(group, offset).position_unit();
    case kBounds:
      return value * group.size;
    default: {
      const KnotTerm& term = task_.terms[static_cast<std::size_t>(group.term)];
      return term.natural ? term.natural(static_cast<std::size_t>(offset % group.width), value) : value;
    }
  }
}

}  // namespace armtune::internal
