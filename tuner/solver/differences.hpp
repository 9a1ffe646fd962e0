#pragma once
// Derivatives by finite differences: where to evaluate, and what the values there say.

#include <vector>

#include "tuner/solver/solver.hpp"

namespace armtune::internal {

/// The points, beside x itself, that the derivatives at x take, coordinate by coordinate; all in the
/// problem's box. A step that leaves the box is made towards the inside, and shortened where neither side has
/// room.
std::vector<std::vector<double>> difference_points(const SolverProblem& problem, const SolverOptions& options,
                                                   const std::vector<double>& x);

/// Sets the gradients of `answer`, whose value is that at x. values: those at difference_points, in order.
void set_gradients(const SolverProblem& problem, const SolverOptions& options, const std::vector<double>& x,
                   const std::vector<SolverValue>& values, SolverAnswer& answer);

}  // namespace armtune::internal
