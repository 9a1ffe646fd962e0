#pragma once
// Decides which steps of a sequential quadratic program count as progress. A filter looks at objective and
// violation (Fletcher and Leyffer, Math. Prog. 91, 2002). Where even the subproblem must violate rows, the l1
// merit function decides instead (Nocedal and Wright, Numerical Optimization, 18.5).

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
  /// Allows steps to end with a largest violation of this, or of what was allowed before if that is more.
  void allow(double largest);
  /// True if the step is accepted; it is `part` of the step that the model describes. The new point must be
  /// better in objective or in violation than every remembered point. If the model promises a better
  /// objective and the violation is small, the objective must fall by a part of that promise. price: of a
  /// mean violation, in units of the objective.
  bool accepts(const Judged& before, const Judged& model, const Judged& after, double part, double price);

 private:
  std::vector<Judged> remembered_;
  double largest_allowed_ = 0.0;
};

}  // namespace armtune::internal
