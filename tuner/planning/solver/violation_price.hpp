#pragma once
// Controls the price of constraint violations: one common factor on the penalties of all rows that may be
// violated (elastic rows). The solver raises the price until no row is violated any more, or until it finds
// that the problem is infeasible.

#include "tuner/quadratic/quadratic_program.hpp"

namespace armtune::internal {

/// Returns by how much a row's value is outside its bounds; infinite if the value is NaN.
double violation(const RowBounds& bounds, Eigen::Index row, double value);

class ViolationPrice {
 public:
  /// The bounds must outlive this object. tolerance: largest violation that counts as none. y (rows): initial
  /// multipliers. With the first price, the penalty of every elastic row is at least twice its multiplier.
  ViolationPrice(const RowBounds& bounds, double tolerance, const Eigen::VectorXd& y);

  double value() const { return value_; }
  /// True if the price is not to be raised any more.
  bool highest() const;
  /// Returns the penalty of every row at this price (rows), infinite for a hard row.
  Eigen::VectorXd penalties() const { return value_ * bounds_.penalty; }
  /// Returns the largest penalty of an elastic row at this price, or 0 if no row is elastic.
  double dearest() const { return value_ * dearest_; }
  void raise();

  /// True if, for some violated row, the multiplier has reached the penalty. row: values of the rows.
  bool paid(const Eigen::VectorXd& row, const Eigen::VectorXd& y) const;
  /// True if several iterations at this price did not reduce the sum of all violations noticeably. Must be
  /// called in every iteration.
  bool no_less_violated(int iteration, const Eigen::VectorXd& row);

 private:
  const RowBounds& bounds_;
  double tolerance_;
  double value_ = 1.0;
  double dearest_ = 0.0;  ///< largest finite penalty before the factor is applied
  int least_at_ = 0;      ///< iteration in which least_ was found
  double least_;          ///< least sum of violations at this price
};

}  // namespace armtune::internal
