#pragma once
// Turns the optimisation of a motion into a nonlinear program (direct transcription). The jerk of the motion
// is piecewise constant. The unknowns are position q, velocity q' and acceleration q'' of every coordinate at
// every knot (point of the time grid), and the free durations. Between two knots, the motion is an exact
// cubic. With h the time between the knots, and q_next the value of q at the second knot:
//   q_next  = q + h * q' + h^2 * (q''/3 + q_next''/6)
//   q_next' = q' + h * (q'' + q_next'')/2
// Limits of position, velocity and acceleration are satisfied between the knots as well:
// - q'' is linear there. It satisfies its limit if it does so at the knots.
// - q' is a parabola with the control points q', q' + h * q''/2 and q_next'. If these satisfy the velocity
//   limit, so does the parabola (Farin, Curves and Surfaces for CAGD, chapter 4).
// - q has the control points q, q + h * q'/3, q + 2 * h * q'/3 + h^2 * q''/6 and q_next. If these satisfy the
//   position limits, so does q.
// Source: Betts, Practical Methods for Optimal Control Using Nonlinear Programming, chapter 4.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/robot/chain.hpp"
#include "tuner/planning/solver/nonlinear_program.hpp"
#include "tuner/planning/transcription/knot_term.hpp"
#include "tuner/planning/transcription/time_grid.hpp"
#include "tuner/planning/transcription/trajectory.hpp"

namespace armtune::internal {

/// Returns the number by which a value between two bounds is divided, so that a violation is relative to its
/// limit. This is the largest magnitude of the finite bounds, or 1 if that is zero or no bound is finite.
inline double unit_of(double lower, double upper) {
  const double largest =
      std::max(std::isfinite(lower) ? std::abs(lower) : 0.0, std::isfinite(upper) ? std::abs(upper) : 0.0);
  return largest > 0.0 ? largest : 1.0;
}

/// A joint, or the path coordinate, with its limits (inf: none).
struct Coordinate {
  std::string name;
  std::string unit = "rad";  ///< unit of its position
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  double least_velocity = -std::numeric_limits<double>::infinity();
  /// Returns the lower bound of q': the larger of -velocity and least_velocity.
  double lowest_velocity() const { return std::max(-velocity, least_velocity); }
  bool limits_position() const { return std::isfinite(lower) || std::isfinite(upper); }
  double position_unit() const { return unit_of(lower, upper); }
  bool limits_velocity() const { return std::isfinite(lowest_velocity()) || std::isfinite(velocity); }
  /// Returns the number by which velocities are divided, so that a violation is relative to the limit.
  double velocity_unit() const { return std::isfinite(velocity) ? velocity : velocity_scale; }
  double velocity = std::numeric_limits<double>::infinity();
  double acceleration = std::numeric_limits<double>::infinity();
  double jerk = std::numeric_limits<double>::infinity();
  double velocity_scale = 1.0;      ///< typical size of q', by which this unknown is scaled
  double acceleration_scale = 1.0;  ///< typical size of q'', by which this unknown is scaled
};

struct Smoothness {
  double acceleration = 0.0;  ///< cost per second of (q'' / acceleration_scale)^2 / 2
  double jerk = 0.0;          ///< cost per second of (1 s * jerk / acceleration_scale)^2 / 2
};

struct TrajectoryTask {
  std::optional<Chain> chain;  ///< none: the terms need only coordinates, no poses
  TimeGrid grid;
  std::vector<Coordinate> coordinates;  ///< the joints, then perhaps the path coordinate
  std::vector<KnotTerm> terms;
  Smoothness smoothness;
  double duration_cost = 0.0;  ///< per second of free durations
  double penalty = 10.0;       ///< cost per unit of violation; violations are relative to their limits
};

/// The meaning of a row of the program, in the user's words.
struct RowMeaning {
  std::string limit;  ///< "velocity", "torque", "tool path"...
  std::string part;   ///< joint or axis
  int knot = 0;
  std::string unit;  ///< unit of the value that `natural` returns
};

class TrajectoryProgram : public NonlinearProgram {
 public:
  explicit TrajectoryProgram(TrajectoryTask task);

  void evaluate(const Eigen::VectorXd& z, Eigen::VectorXd& residual, Eigen::VectorXd& row) override;
  void linearize(const Eigen::VectorXd& z, Eigen::VectorXd& residual, Eigen::VectorXd& row) override;

  void curve(const Eigen::VectorXd& z, const Eigen::VectorXd& residual, const Eigen::VectorXd& y) override;

  double objective(const Eigen::VectorXd& z);
  const TrajectoryTask& task() const { return task_; }
  Eigen::VectorXd unknowns(const Trajectory& trajectory) const;
  Trajectory trajectory(const Eigen::VectorXd& z) const;
  RowMeaning meaning(Eigen::Index row) const;
  /// Returns a row's value or bound in the unit of its meaning.
  double natural(Eigen::Index row, double value) const;
  /// Returns a guess of this program's multipliers, made from those of the same task on a coarser grid.
  Eigen::VectorXd multipliers_from(const TrajectoryProgram& coarse, const Eigen::VectorXd& y) const;

 private:
  enum GroupKind { kDynamics, kJerk, kInside, kInsidePosition, kBounds, kTerm };
  struct RowGroup {
    Eigen::Index first_row;
    std::string limit;
    int kind;     ///< a GroupKind, from which meaning() finds what a row of the group stands for
    int term;     ///< index of the term, or of the coordinate
    int width;    ///< number of rows per knot
    int order;    ///< order of the derivative that the group bounds, if it bounds one
    double size;  ///< value in natural units of a row value of 1, if the group bounds a coordinate
  };
  struct TermBlocks {
    int first_block = 0;  ///< in `rows` or `residuals`, one block per knot
  };
  /// Returns an unknown's column. At each knot the coordinates follow one another, each with its derivatives.
  /// This order gives the Cholesky factor the least fill-in, because each coordinate is coupled only with
  /// itself at the next knot.
  int column(int knot, int order, int coordinate) const;
  bool is_acceleration(int column) const { return column < 3 * m_ * task_.grid.knots() && column % 3 == 2; }
  double scale(int order, int coordinate) const;
  const RowGroup& group_of(Eigen::Index row) const;
  /// Returns the coordinates whose jerk, or whose velocity or position between knots, the group limits.
  const std::vector<int>& limited(const RowGroup& group) const {
    return group.kind == kJerk     ? jerk_limited_
           : group.kind == kInside ? velocity_limited_
                                   : position_limited_;
  }
  /// Returns the coordinate (one of limited(group)) that the row at this offset in the group belongs to.
  const Coordinate& limited_at(const RowGroup& group, int offset) const {
    const int rows_each = group.kind == kInsidePosition ? 2 : 1;
    const auto place = static_cast<std::size_t>(offset % group.width / rows_each);
    return task_.coordinates[static_cast<std::size_t>(limited(group)[place])];
  }
  /// Returns the given columns of interval k, followed by the column of its phase's duration if this duration
  /// is free.
  std::vector<int> with_duration(std::vector<int> columns, int k) const;
  void lay_out_intervals();
  void lay_out_continuity();
  void lay_out_jerk();
  void lay_out_velocity_inside();
  void lay_out_position_inside();
  void lay_out_smoothness();
  void lay_out_bounds();
  void lay_out_terms();
  void lay_out_curvature();
  void curve_intervals(const Eigen::VectorXd& z, const Eigen::VectorXd& y);
  void curve_knots(const Eigen::VectorXd& z, const Eigen::VectorXd& residual, const Eigen::VectorXd& y);
  Knot knot_at(const Eigen::VectorXd& z, const std::vector<double>& durations, int k) const;
  void add_bounds(int count, double lower, double upper, bool hard);
  std::vector<double> durations(const Eigen::VectorXd& z) const;
  void intervals_at(const Eigen::VectorXd& z, Eigen::VectorXd& residual, Eigen::VectorXd& row,
                    bool derivatives);
  void knots_at(const Eigen::VectorXd& z, Eigen::VectorXd& residual, Eigen::VectorXd& row, bool derivatives);
  double part_of_phase(int knot, std::size_t phase) const;
  std::vector<int> free_phases_until(int knot) const;
  std::vector<int> knot_columns(int knot, bool on_velocity, bool on_acceleration, bool on_time) const;
  void term_rows(const KnotTerm& term, const Knot& knot, double* value, double* derivative);
  void write_term(std::size_t t, const Knot& knot, Eigen::VectorXd& values, BlockRows& target,
                  bool derivatives);

  TrajectoryTask task_;
  int m_ = 0;  ///< number of coordinates
  int joints_ = 0;
  std::vector<int> duration_column_;  ///< [phase]; -1: fixed
  std::vector<int> phase_of_interval_;
  /// Indices of the first block of each kind in `rows`.
  int first_dynamics_ = 0, first_jerk_ = 0, first_inside_ = 0, first_inside_position_ = 0;
  std::vector<int> jerk_limited_, velocity_limited_, position_limited_;  ///< indices of coordinates
  std::vector<int> interval_curvature_;  ///< [interval]: its first block in `curvature`; -1: none
  std::vector<int> knot_curvature_;      ///< [knot]: its block in `curvature`; -1: none
  int first_smooth_ = -1;                ///< first smoothness block in `residuals`; -1: none
  std::vector<TermBlocks> term_blocks_;
  std::vector<double> lower_, upper_, penalty_;
  std::vector<RowGroup> groups_;
  Eigen::VectorXd scratch_q_, scratch_qd_, scratch_qdd_, scratch_time_;
};

}  // namespace armtune::internal
