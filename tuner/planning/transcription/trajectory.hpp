#pragma once
// Stores and evaluates a planned motion on a time grid. Between two knots (points of the grid) the motion is
// cubic, so its jerk is piecewise constant.

#include <Eigen/Core>
#include <vector>

#include "tuner/planning/transcription/time_grid.hpp"

namespace armtune::internal {

struct Trajectory {
  std::vector<double> time;                          ///< times of the knots, ascending [s]
  Eigen::MatrixXd position, velocity, acceleration;  ///< coordinates (joints, path coordinate) x knots
  std::vector<double> durations;                     ///< one per phase [s]
};

/// The position, velocity and acceleration of every coordinate at a time t [s]. Before the start and after
/// the end, point_at() returns the values of the nearer end.
struct TrajectoryPoint {
  Eigen::VectorXd position, velocity, acceleration;
};
TrajectoryPoint point_at(const Trajectory& trajectory, double t);

/// Returns the same motion at the knots of another grid with the same phases. The phases keep the durations
/// that they have in the trajectory. The durations of the grid are not used.
Trajectory on_grid(const Trajectory& trajectory, const TimeGrid& grid);

/// Returns the motion through the same positions with the phase durations of `grid`, which has the same
/// number of knots. Velocities and accelerations are scaled accordingly, except those at the start.
Trajectory in_durations_of(const TimeGrid& grid, Trajectory trajectory);

/// Replaces velocities and accelerations by those of the cubic spline through the positions. At start and
/// end, the spline has the motion's own velocities (de Boor, A Practical Guide to Splines, chapter IV). The
/// motion must have at least 2 knots.
void make_continuous(Trajectory& motion);

}  // namespace armtune::internal
