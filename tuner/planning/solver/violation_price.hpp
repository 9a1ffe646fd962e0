#pragma once
// What violated rows cost: a price times their penalties, which goes up until nothing is violated any more,
// or until it is plain that something always will be.

#include "tuner/planning/solver/quadratic_program.hpp"

namespace armtune::internal {

/// By how much a row's value is outside its bounds; infinite where it is not a number.
double violation(const RowBounds& bounds, Eigen::Index row, double value);

class ViolationPrice {
 public:
  /// Bounds must outlive it. tolerance: a violation that counts as none; y (rows): multipliers to start from,
  /// no violation is to be worth them.
  ViolationPrice(const RowBounds& bounds, double tolerance, const Eigen::VectorXd& y);

  double value() const { return value_; }
  bool highest() const;
  /// Of every row (rows), infinite where it is hard.
  Eigen::VectorXd penalties() const { return value_ * bounds_.penalty; }
  /// Of any elastic row, 0 without one.
  double dearest() const { return value_ * dearest_; }
  void raise();

  /// Whether a violated row pulls with all it may.
  bool paid(const Eigen::VectorXd& row, const Eigen::VectorXd& y) const;
  /// To be told each iteration: whether the last ones at this price made nothing of the violation.
  bool no_less_violated(int iteration, const Eigen::VectorXd& row);

 private:
  const RowBounds& bounds_;
  double tolerance_;
  double value_ = 1.0;
  double dearest_ = 0.0;  ///< penalty
  int least_at_ = 0;      ///< iteration
  double least_;          ///< sum of violations at this price
};

}  // namespace armtune::internal
