#include "tuner/planning/solver/violation_price.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kPriceFactor = 100.0;
constexpr double kHighest = 100.0;
constexpr double kLess = 0.9;         // the sum of violations must fall to this share of the least so far
constexpr int kTrialIterations = 15;  // within this many iterations; otherwise the price is too low

}  // namespace

double violation(const RowBounds& bounds, Index row, double value) {
  if (std::isnan(value)) return INFINITY;
  return std::max({0.0, bounds.lower[row] - value, value - bounds.upper[row]});
}

ViolationPrice::ViolationPrice(const RowBounds& bounds, double tolerance, const VectorXd& y)
    : bounds_(bounds), tolerance_(tolerance), least_(INFINITY) {
  for (Index i = 0; i < y.size(); ++i) {
    if (!std::isfinite(bounds.penalty[i])) continue;
    dearest_ = std::max(dearest_, bounds.penalty[i]);
    value_ = std::max(value_, 2.0 * std::abs(y[i]) / bounds.penalty[i]);
  }
}

bool ViolationPrice::highest() const {
  return value_ >= kHighest;
}

void ViolationPrice::raise() {
  value_ *= kPriceFactor;
  least_ = INFINITY;
}

bool ViolationPrice::paid(const VectorXd& row, const VectorXd& y) const {
  for (Index i = 0; i < row.size(); ++i) {
    if (violation(bounds_, i, row[i]) > tolerance_ && std::abs(y[i]) > 0.99 * value_ * bounds_.penalty[i])
      return true;
  }
  return false;
}

bool ViolationPrice::no_less_violated(int iteration, const VectorXd& row) {
  double sum = 0.0;
  for (Index i = 0; i < row.size(); ++i) sum += violation(bounds_, i, row[i]);
  if (sum < kLess * least_) {
    least_ = sum;
    least_at_ = iteration;
  }
  return iteration - least_at_ >= kTrialIterations;
}

}  // namespace armtune::internal
