#pragma once
// Defines the time grid of a trajectory. The grid is a series of phases, and each phase is divided into
// intervals of equal length. The duration of a phase is fixed, or free, that is, found by the optimisation.
// The ends of the intervals are the knots of the grid.

#include <string>
#include <vector>

namespace armtune::internal {

struct Phase {
  std::string name;
  int intervals = 1;
  double duration = 1.0;  ///< [s]; the first guess if the phase is free
  bool free = false;
  double shortest = 1e-3;  ///< bounds of a free duration [s]
  double longest = 1e3;
};

struct TimeGrid {
  double start = 0.0;  ///< [s]
  std::vector<Phase> phases;

  int intervals() const {
    int sum = 0;
    for (const Phase& phase : phases) sum += phase.intervals;
    return sum;
  }
  int knots() const { return intervals() + 1; }
  /// Returns the first knot of a phase. If `phase` is the number of phases, returns the grid's last knot.
  int first_knot(int phase) const {
    int knot = 0;
    for (int p = 0; p < phase; ++p) knot += phases[static_cast<std::size_t>(p)].intervals;
    return knot;
  }
  /// Returns the phase that an interval lies in.
  int phase_of(int interval) const {
    int p = 0;
    while (interval >= phases[static_cast<std::size_t>(p)].intervals)
      interval -= phases[static_cast<std::size_t>(p++)].intervals;
    return p;
  }
};

}  // namespace armtune::internal
