#pragma once
// Accepts or rejects the steps of sequential quadratic programming. The filter compares objective and
// constraint violation of a new point with those of earlier points (Fletcher and Leyffer, Math. Prog. 91,
// 2002). If even the solution of the subproblem violates constraints, the l1 merit function decides instead
// (Nocedal and Wright, Numerical Optimization, 18.5).

#include <vector>

namespace armtune::internal {

/// The quantities by which the filter judges a point.
struct Judged {
  double objective = 0.0;
  double violation = 0.0;  ///< mean over the knots
  double largest = 0.0;    ///< largest violation of a row
};

class StepFilter {
 public:
  void clear() { remembered_.clear(); }
  /// Allows steps whose new point violates a row by up to `largest`. If a larger violation was allowed
  /// before, it remains allowed.
  void allow(double largest);
  /// True if the step from `before` to `after` is accepted. The new point must be better than every
  /// remembered point, in objective or in violation. If the model predicts a better objective and the
  /// violation is small, the objective must fall by at least a fixed fraction of the predicted decrease.
  /// model: predicted values after the full step. part: share of the full step that was taken. price: cost of
  /// a mean violation, in units of the objective.
  bool accepts(const Judged& before, const Judged& model, const Judged& after, double part, double price);

 private:
  std::vector<Judged> remembered_;
  double largest_allowed_ = 0.0;
};

}  // namespace armtune::internal
