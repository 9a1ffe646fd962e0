#pragma once
// Minimises a weighted sum of maxima under constraints that are maxima as well, by sequential quadratic
// programming in a trust region. Every iteration models each maximum by linear rows (minimax_model.hpp),
// solves the epigraph program (epigraph_program.hpp) and evaluates the new point. The exact merit function
//
//   merit = objective + penalty * sum of violations
//
// decides whether the step is taken. The ratio of its actual to its predicted decrease sets the size of the
// trust region (Nocedal and Wright, Numerical Optimization, 2nd ed., algorithm 18.4 and section 18.5). A
// model may cost as much as many evaluations. Therefore a model that is right is used for a longer step as
// well, and a step that violates constraints more than predicted is corrected once.
//
//   MinimaxProblem problem{lower, upper, model, evaluate};
//   const MinimaxResult found = minimize_maxima(problem, x, value_at_x, {});

#include <functional>
#include <optional>

#include "tuner/minimax/minimax_model.hpp"
#include "tuner/solver/solver.hpp"

namespace armtune::internal {

struct MinimaxProblem {
  Eigen::VectorXd lower, upper;  ///< bounds of the variables (n)
  /// Returns the model at x, which is the start or a point that was evaluated since the last model. Returns
  /// nothing to end the search.
  std::function<std::optional<MinimaxModel>(const Eigen::VectorXd& x)> model;
  /// Returns the values at x, or nothing to end the search. The constraints are those of the model, in order.
  /// There may be more, which are not modelled.
  std::function<std::optional<SolverValue>(const Eigen::VectorXd& x)> evaluate;
};

/// Options of the search. Lengths are in the units of the variables, the other numbers in those of the
/// objective.
struct MinimaxOptions {
  double radius = 0.05;           ///< initial trust region: largest change of a variable
  double largest_radius = 0.2;    ///< the trust region grows at most to this
  double smallest_radius = 5e-4;  ///< the search ends when the trust region is smaller than this
  double least_decrease = 1e-5;   ///< the search ends when the predicted decrease is smaller than this
  double penalty = 1.0;           ///< initial cost of a violation; raised if the model demands it
  double largest_penalty = 1e4;
};

enum class MinimaxEnd {
  kDecrease,  ///< the model predicts no decrease worth another evaluation
  kRadius,    ///< the trust region became too small
  kStopped    ///< `model` or `evaluate` ended the search
};

struct MinimaxResult {
  MinimaxEnd ended = MinimaxEnd::kStopped;
  Eigen::VectorXd x;  ///< the last point that was accepted
  SolverValue value;  ///< at x
  int accepted = 0;   ///< number of accepted steps
};

/// Runs the search from x, which is inside the bounds. value: the values at x. Neither `model` nor `evaluate`
/// is called for a point outside the bounds. The sequence of points depends only on the arguments.
MinimaxResult minimize_maxima(const MinimaxProblem& problem, const Eigen::VectorXd& x,
                              const SolverValue& value, const MinimaxOptions& options);

}  // namespace armtune::internal
