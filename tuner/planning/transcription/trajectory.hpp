#pragma once
// A motion on a time grid: cubic between knots, with piecewise constant jerk.

#include <Eigen/Core>
#include <vector>

#include "tuner/planning/transcription/time_grid.hpp"

namespace armtune::internal {

struct Trajectory {
  std::vector<double> time;                          ///< of the knots, ascending [s]
  Eigen::MatrixXd position, velocity, acceleration;  ///< coordinates x knots
  std::vector<double> durations;                     ///< of the phases [s]
};

/// Position, velocity and acceleration of every coordinate at t, held at the ends outside.
struct TrajectoryPoint {
  Eigen::VectorXd position, velocity, acceleration;
};
TrajectoryPoint point_at(const Trajectory& trajectory, double t);

/// The same motion at the knots of another grid with the same phases, whose durations become the
/// trajectory's.
Trajectory on_grid(const Trajectory& trajectory, const TimeGrid& grid);

/// The same way, knot by knot, in the durations of the grid, which has as many knots: faster or slower
/// throughout, but with its own state at the start.
Trajectory in_durations_of(const TimeGrid& grid, Trajectory trajectory);

/// Gives the motion the velocities and accelerations of the cubic spline through its positions that begins
/// and ends with the velocities it has (de Boor, A Practical Guide to Splines, chapter IV): at least 2 knots.
void make_continuous(Trajectory& motion);

}  // namespace armtune::internal
