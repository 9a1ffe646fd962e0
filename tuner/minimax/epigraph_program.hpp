#pragma once
// Computes the step that minimises a minimax model (minimax_model.hpp) plus a quadratic term inside a box. In
// epigraph form, this is a quadratic program. Each maximum becomes a variable t, which no row may exceed:
//
//   minimise    sum_k weight_k t_k + penalty sum_c v_c + d^T B d / 2
//   subject to  value_i + gradient_i^T d <= t_k    for every row i of term k
//               value_i + gradient_i^T d <= v_c    for every row i of constraint c
//               v_c >= 0,   lower <= d <= upper
//
// v_c is the violation of constraint c. If the penalty is large enough, it is zero where the linearised
// constraints can be satisfied in the box (exact penalty; Nocedal and Wright, Numerical Optimization, 17.2).
// Otherwise the step violates them as little as the penalty demands, so the program always has a solution. A
// term with one row needs no t. Its gradient is added to that of the objective.

#include "tuner/minimax/minimax_model.hpp"

namespace armtune::internal {

/// The box of a step: the bounds of the variables and the trust region.
struct StepBounds {
  Eigen::VectorXd lower;  ///< not above 0
  Eigen::VectorXd upper;  ///< not below 0
};

struct EpigraphStep {
  Eigen::VectorXd d;
  /// Multiplier of every row, not negative. In each term they add up to its weight, in each constraint to at
  /// most the penalty.
  std::vector<Eigen::VectorXd> terms;
  std::vector<Eigen::VectorXd> constraints;
};

/// Solves the program. B: (n x n) symmetric positive definite. If rounding errors prevent an exact solution,
/// the step is inexact; the model itself shows what it is worth. d is inside the bounds in any case.
EpigraphStep solve_epigraph(const MinimaxModel& model, const Eigen::MatrixXd& B, const StepBounds& bounds,
                            double penalty);

}  // namespace armtune::internal
