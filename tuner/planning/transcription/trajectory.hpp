#pragma once
// A planned motion on a time grid. It is cubic between two knots, so the jerk is piecewise constant.

#include <Eigen/Core>
#include <vector>

#include "tuner/planning/transcription/time_grid.hpp"

namespace armtune::internal {

struct Trajectory {
  std::vector<double> time;                          ///< times of the knots, ascending [s]
  Eigen::MatrixXd position, velocity, acceleration;  ///< coordinates x knots
  std::vector<double> durations;                     ///< one per phase [s]
};

/// The position, velocity and acceleration of every coordinate at a time t [s]. Before the start and after
/// the end they are those of the nearer end.
struct TrajectoryPoint {
  Eigen::VectorXd position, velocity, acceleration;
};
TrajectoryPoint point_at(const Trajectory& trajectory, double t);

/// Returns the same motion at the knots of another grid with the same phases. The phases take the
/// trajectory's durations in place of the grid's.
Trajectory on_grid(const Trajectory& trajectory, const TimeGrid& grid);

/// Returns the motion through the same positions with the phase durations of `grid`, which has as many knots.
/// Velocities and accelerations are scaled accordingly, except those at the start.
Trajectory in_durations_of(const TimeGrid& grid, Trajectory trajectory);

/// Replaces velocities and accelerations by those of the cubic spline through the positions. It starts
/// and ends with the motion's own velocities (de Boor, A Practical Guide to Splines, chapter IV). The motion
/// must have at least 2 knots.
void make_continuous(Trajectory& motion);

}  // namespace armtune::internal
