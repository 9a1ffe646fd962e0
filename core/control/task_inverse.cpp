#include "core/control/task_inverse.hpp"

#include <cmath>

namespace armtune {

void TaskInverse::compute(const Jacobian& J, const InverseDamping& damping) {
  using Mat6 = Eigen::Matrix<double, 6, 6>;
  J_ = &J;
  const auto n = J.cols();
  if (n == 6) {
    lu_.compute(Mat6(J));
    manipulability_ = std::abs(lu_.determinant());
    damped_ = !(manipulability_ >= damping.threshold);
    if (!damped_) return;
  }
  Mat6 JJt;
  JJt.noalias() = J * J.transpose();
  if (n > 6) {
    llt_.compute(JJt);
    // det(J J^T) is the square of the product of the Cholesky factor's diagonal; a failed factorisation
    // means that J has lost rank.
    manipulability_ = llt_.info() == Eigen::Success ? llt_.matrixLLT().diagonal().prod() : 0.0;
    damped_ = !(manipulability_ >= damping.threshold);
    if (!damped_) return;
  } else if (n < 6) {
    const JointMatrix JtJ = J.transpose() * J;
    manipulability_ = std::sqrt(std::max(0.0, JtJ.determinant()));
    damped_ = true;
  }
  JJt.diagonal().array() += n < 6 ? damping.psi : damping.at(manipulability_);
  llt_.compute(JJt);
}

void TaskInverse::apply(const Vec6& b, JointVector& x) const {
  if (J_->cols() == 6 && !damped_) {
    x = lu_.solve(b);
    return;
  }
  const Vec6 y = llt_.solve(b);
  x.noalias() = J_->transpose() * y;
}

}  // namespace armtune
