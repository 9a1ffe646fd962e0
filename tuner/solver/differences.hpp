#pragma once
// Derivatives by finite differences: the points to evaluate, and the gradients that follow from their values.

#include <vector>

#include "tuner/solver/solver.hpp"

namespace armtune::internal {

/// Returns the points that the derivatives at x need besides x itself, coordinate by coordinate. All are in
/// the problem's box. A step that would leave the box is made towards the inside, and shortened if neither
/// side has room.
std::vector<std::vector<double>> difference_points(const SolverProblem& problem, const SolverOptions& options,
                                                   const std::vector<double>& x);

/// Sets the gradients of `answer`, whose value is that at x. values: those at difference_points, in order.
void set_gradients(const SolverProblem& problem, const SolverOptions& options, const std::vector<double>& x,
                   const std::vector<SolverValue>& values, SolverAnswer& answer);

}  // namespace armtune::internal
