#pragma once
// Which steps of a sequential quadratic program count as progress: a filter of objective and violation
// (Fletcher and Leyffer, Math. Prog. 91, 2002), and the l1 merit function where even the subproblem must
// violate rows (Nocedal and Wright, Numerical Optimization, 18.5).

#include <vector>

namespace armtune::internal {

struct Judged {
  double objective = 0.0;
  double violation = 0.0;  ///< mean over the knots
  double largest = 0.0;    ///< violation of a row
};

class StepFilter {
 public:
  void clear() { remembered_.clear(); }
  /// Steps may end with a largest violation of this, or of what was allowed before.
  void allow(double largest);
  /// A step, `part` of the one the model promised: better in objective or in violation than every point it
  /// remembers, and, where the model promises a better objective and violation is small, better in objective
  /// by part of what is promised. price: of a mean violation, in units of the objective.
  bool accepts(const Judged& before, const Judged& model, const Judged& after, double part, double price);

 private:
  std::vector<Judged> remembered_;
  double largest_allowed_ = 0.0;
};

}  // namespace armtune::internal
