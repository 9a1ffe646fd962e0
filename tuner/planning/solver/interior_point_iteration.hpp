#pragma once
// One program on its way through the interior point method: where it is, its residuals, one step.

#include <cmath>
#include <vector>

#include "tuner/planning/solver/condensed_system.hpp"
#include "tuner/planning/solver/interior_point.hpp"

namespace armtune::internal {

/// The unknowns, or one direction of them. y multiplies G x - w - over + under = 0; w lies between the
/// bounds.
struct InteriorUnknowns : LinearUnknowns {
  Eigen::VectorXd w;             ///< value of the row, strictly between its bounds; of an equation the bound
  Eigen::VectorXd upper, lower;  ///< multipliers of w's bounds, 0 where there is none
  Eigen::VectorXd over, under;   ///< elastic violations; their multipliers are penalty - y and penalty + y

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

/// Right-hand sides of the complementarity conditions: what is wanted of each product minus what it is.
struct InteriorPairs {
  Eigen::VectorXd upper, lower, over, under;
};

/// One program being solved.
class InteriorPointIteration {
 public:
  InteriorPointIteration(const QuadraticProgram& program, NormalMatrix& normal, SparseCholesky& cholesky);
  /// Where multipliers say that a bound is active, w starts beside that bound and y is kept.
  void start(const Eigen::VectorXd& x, const Eigen::VectorXd& y, double mu);
  void measure(InteriorPointResult& result);
  /// Predictor, then corrector. False if the condensed matrix is not positive definite.
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
  void keep_within_penalty(Eigen::Index i);
  /// Moves w, the row's value, between its bounds, and gives it multipliers.
  void start_range(Eigen::Index i, double mu);
  /// Mean product of the pairs, here or after `part` of a direction.
  double complementarity(const InteriorUnknowns* d, double part) const;
  /// How far each row gives way to its multiplier, by moving between its bounds (1/theta) or beyond them
  /// (both: yield), and the linear system with it.
  bool factorize();
  /// Every product is to become `target`; affine: the direction whose second order is made up for.
  void aim(double target, const InteriorUnknowns* affine);
  /// What moves w beside y: from its stationarity and its pairs.
  double push_on_w(Eigen::Index i) const;
  /// Solves the linearised conditions for the pairs aimed at; not exact: with the dual proximal part.
  void direction(InteriorUnknowns& d, bool exact);
  /// The longest part of a direction, up to 1, that keeps every pair positive.
  double longest(const InteriorUnknowns& d) const;

  const QuadraticProgram& program_;
  const BlockRows& G_;
  const RowBounds& bounds_;
  Eigen::Index rows_;
  std::vector<unsigned> kind_;  ///< of each row
  CondensedSystem system_;
  Eigen::Index count_ = 0;  ///< of pairs
  double mu_ = 0.0;
  InteriorUnknowns at_, predictor_, corrector_;
  InteriorPairs pairs_;
  Eigen::VectorXd rd_, rp_, rw_;  ///< residuals of stationarity, rows and w
  Eigen::VectorXd theta_, yield_, e_;
  double rows_wanted_ = 0.0;  ///< of the linear system's rows
};

}  // namespace armtune::internal
