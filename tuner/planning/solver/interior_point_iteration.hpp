#pragma once
// One program on its way through the interior point method: where it is, its residuals, one step.

#include <cmath>

#include "tuner/planning/solver/interior_point.hpp"

namespace armtune {

/// The unknowns, or one direction of them. y multiplies G x - w - over + under = 0; w lies between the
/// bounds.
struct InteriorUnknowns {
  Eigen::VectorXd x, y;
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
  /// Predictor, then corrector; tolerance: of the sum of the pairs' products. False if the condensed matrix
  /// is not positive definite.
  bool advance(double tolerance);
  const InteriorUnknowns& at() const { return at_; }

 private:
  bool equation(Eigen::Index i) const { return bounds_.lower[i] == bounds_.upper[i]; }
  bool has_upper(Eigen::Index i) const { return std::isfinite(bounds_.upper[i]) && !equation(i); }
  bool has_lower(Eigen::Index i) const { return std::isfinite(bounds_.lower[i]) && !equation(i); }
  bool elastic(Eigen::Index i) const { return std::isfinite(bounds_.penalty[i]); }
  double below_upper(const InteriorUnknowns& at, Eigen::Index i) const { return bounds_.upper[i] - at.w[i]; }
  double above_lower(const InteriorUnknowns& at, Eigen::Index i) const { return at.w[i] - bounds_.lower[i]; }
  void keep_within_penalty(Eigen::Index i);
  void start_range(Eigen::Index i, double mu);
  /// Mean product of the pairs.
  double complementarity(const InteriorUnknowns& at) const;
  void hessian_times(const Eigen::VectorXd& v, Eigen::VectorXd& result);
  /// K = H + delta I + G^T D G. 1/D: how far a row gives way to its multiplier, by moving between its bounds
  /// (theta) or beyond them.
  bool factorize();
  /// Every product is to become `target`; affine: the direction whose second order is made up for.
  void aim(double target, const InteriorUnknowns* affine);
  /// What moves w beside y: from its stationarity and its pairs.
  double push_on_w(Eigen::Index i) const;
  /// Solves the linearised conditions for the pairs aimed at.
  void direction(InteriorUnknowns& d, int refinements);
  /// [H + delta, G^T; G, -1/D] (dx, dy) = (rd, e), condensed to K, then refined against the system as it
  /// stands.
  void solve_condensed(InteriorUnknowns& d, int refinements);
  static bool small(const Eigen::VectorXd& residual, const Eigen::VectorXd& beside);
  /// The longest part of a direction, up to 1, that keeps every pair positive.
  double longest(const InteriorUnknowns& d) const;

  const QuadraticProgram& program_;
  const BlockRows& R_;
  const BlockRows& G_;
  const RowBounds& bounds_;
  Eigen::Index rows_;
  NormalMatrix& normal_;
  SparseCholesky& cholesky_;
  Eigen::Index count_ = 0;  ///< of pairs
  double mu_ = 0.0;
  InteriorUnknowns at_, predictor_, corrector_;
  InteriorPairs pairs_;
  Eigen::VectorXd rd_, rp_, rw_;  ///< residuals of stationarity, rows and w
  Eigen::VectorXd theta_, inverse_D_, D_, e_;
  Eigen::VectorXd ones_;  ///< empty: stands for ones
  Eigen::VectorXd r_, r1_, r2_, Gx_, Rx_, Hx_, minus_y_;
};

}  // namespace armtune
