#pragma once
// Iterates the interior point method on one quadratic program. InteriorPointIteration stores the current
// point and its residuals, and computes the next step. InteriorPoint takes such steps until they converge.

#include <cmath>
#include <vector>

#include "tuner/quadratic/condensed_system.hpp"
#include "tuner/quadratic/interior_point.hpp"

namespace armtune::internal {

/// The unknowns, or a direction in their space. x are the variables of the program, and w the values of its
/// rows, which lie between their bounds. y are the multipliers of the equations G x - w - over + under = 0.
struct InteriorUnknowns : LinearUnknowns {
  Eigen::VectorXd w;             ///< value of each row, strictly between its bounds; the bound of an equation
  Eigen::VectorXd upper, lower;  ///< multipliers of w's bounds, 0 where there is no bound
  Eigen::VectorXd over, under;   ///< violations of upper, lower bound; multipliers: penalty - y, penalty + y

  void set_zero(Eigen::Index variables, Eigen::Index rows) {
    x.setZero(variables);
    for (Eigen::VectorXd* part : {&y, &w, &upper, &lower, &over, &under}) part->setZero(rows);
  }
  void add(double factor, const InteriorUnknowns& step) {
    x += factor * step.x;
    y += factor * step.y;
    w += factor * step.w;
    upper += factor * step.upper;
    lower += factor * step.lower;
    over += factor * step.over;
    under += factor * step.under;
  }
};

/// The right-hand sides of the complementarity conditions: for each pair of slack and multiplier, the wanted
/// product minus the present product, with the second order correction if there is one.
struct InteriorPairs {
  Eigen::VectorXd upper, lower, over, under;
};

/// The iteration on one program that is being solved. A pair is a slack and its multiplier; at the solution
/// their product is 0.
class InteriorPointIteration {
 public:
  InteriorPointIteration(const QuadraticProgram& program, NormalMatrix& normal, Cholesky& cholesky);
  /// Sets the starting point. If a row's multiplier y shows that a bound is active, w starts close to that
  /// bound, and y is kept. mu: product of slack and multiplier to start with.
  void start(const Eigen::VectorXd& x, const Eigen::VectorXd& y, double mu);
  /// Computes the residuals at the present point, and writes their sizes into `result`.
  void measure(InteriorPointResult& result);
  /// Takes one step: the predictor, then the corrector. Returns false if the condensed matrix is not positive
  /// definite. Requires a call of measure() at the present point.
  bool advance(const InteriorPointOptions& options);
  const InteriorUnknowns& at() const { return at_; }

 private:
  enum Kind : unsigned { kEquation = 1, kUpper = 2, kLower = 4, kElastic = 8 };
  bool is(Kind kind, Eigen::Index i) const { return (kind_[static_cast<std::size_t>(i)] & kind) != 0; }
  bool equation(Eigen::Index i) const { return is(kEquation, i); }
  bool has_upper(Eigen::Index i) const { return is(kUpper, i); }
  bool has_lower(Eigen::Index i) const { return is(kLower, i); }
  bool elastic(Eigen::Index i) const { return is(kElastic, i); }
  double below_upper(const InteriorUnknowns& at, Eigen::Index i) const { return bounds_.upper[i] - at.w[i]; }
  double above_lower(const InteriorUnknowns& at, Eigen::Index i) const { return at.w[i] - bounds_.lower[i]; }
  /// Clamps the multiplier of an elastic row to 90 % of its penalty.
  void keep_within_penalty(Eigen::Index i);
  /// Moves w, the row's value, to a point between its bounds, and sets its multipliers.
  void start_range(Eigen::Index i, double mu);
  /// Returns the mean product of the pairs at the present point (d null), or after `part` of the direction d.
  double complementarity(const InteriorUnknowns* d, double part) const;
  /// Computes the compliance `yield` of each row (condensed_system.hpp), and factorises the linear system
  /// with it. The compliance has two parts: the motion of w between its bounds (1/theta), and the violation
  /// of an elastic row.
  bool factorize();
  /// Sets the right-hand sides so that the product of every pair becomes `target`. For elastic violations,
  /// the product becomes a fixed small part of `target`. affine: direction whose second order terms are
  /// compensated; null: none.
  void aim(double target, const InteriorUnknowns* affine);
  /// Returns the part of the right-hand side for w that does not depend on y. It consists of the stationarity
  /// residual of w and the right-hand sides of its pairs.
  double push_on_w(Eigen::Index i) const;
  /// Solves the linearised conditions for the right-hand sides that `aim` has set. exact: if false, the error
  /// that the dual proximal part causes (condensed_system.hpp) remains in the direction.
  void direction(InteriorUnknowns& d, bool exact);
  /// Returns the longest part of a direction, up to 1, that keeps every pair positive.
  double longest(const InteriorUnknowns& d) const;

  const QuadraticProgram& program_;
  const BlockRows& G_;
  const RowBounds& bounds_;
  Eigen::Index rows_;
  std::vector<unsigned> kind_;  ///< [row]: sum of the Kind values that apply
  CondensedSystem system_;
  Eigen::Index count_ = 0;  ///< number of pairs
  double mu_ = 0.0;
  InteriorUnknowns at_, predictor_, corrector_;
  InteriorPairs pairs_;
  Eigen::VectorXd rd_, rp_, rw_;  ///< residuals of stationarity, rows and w
  Eigen::VectorXd theta_, yield_, e_;
  double rows_wanted_ = 0.0;  ///< largest residual allowed in the linear system's rows
};

}  // namespace armtune::internal
