#pragma once
// Computes derivatives by finite differences: first the points to evaluate, then the gradients from their
// values.

#include <vector>

#include "tuner/solver/solver.hpp"

namespace armtune::internal {

/// Returns the points that the derivatives at x need besides x itself, coordinate by coordinate. All points
/// lie inside the bounds of the problem. A step that would cross a bound is made in the other direction. If
/// it would cross a bound in both directions, it ends at the bound that is farther away.
std::vector<std::vector<double>> difference_points(const SolverProblem& problem, const SolverOptions& options,
                                                   const std::vector<double>& x);

/// Sets the gradients of `answer`, which already contains the value at x. values: the values at
/// difference_points(), in order.
void set_gradients(const SolverProblem& problem, const SolverOptions& options, const std::vector<double>& x,
                   const std::vector<SolverValue>& values, SolverAnswer& answer);

}  // namespace armtune::internal
