#pragma once
// Derivatives by finite differences: the points to evaluate, and the gradients that follow from their values.

#include <vector>

#include "tuner/solver/solver.hpp"

namespace armtune::internal {

/// Returns the points that the derivatives at x need besides x itself, coordinate by coordinate. All points
/// lie inside the bounds of the problem. A step that would cross a bound is made in the other direction. If
/// neither direction has room for the step, it goes to the bound that is farther away.
std::vector<std::vector<double>> difference_points(const SolverProblem& problem, const SolverOptions& options,
                                                   const std::vector<double>& x);

/// Sets the gradients of `answer`, which already contains the value at x. values: the values at
/// difference_points(), in order.
void set_gradients(const SolverProblem& problem, const SolverOptions& options, const std::vector<double>& x,
                   const std::vector<SolverValue>& values, SolverAnswer& answer);

}  // namespace armtune::internal
