#pragma once
// The manipulability-switched inverse of the Jacobian (equations 3 and 4):
//   m = sqrt(det(J J^T));  m >= threshold: J^-1, or J^T (J J^T)^-1 with more than six joints;
//   otherwise the damped J^T (J J^T + psi I)^-1.

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/common/types.hpp"
#include "core/control/inverse_damping.hpp"

namespace armtune {

class TaskInverse {
 public:
  /// Factorises once for all right-hand sides of a control period. J is 6 x n and is referred to, not copied.
  /// With fewer than six joints J J^T is singular by shape: always damped with all of psi,
  /// m = sqrt(det(J^T J)).
  void compute(const Jacobian& J, const InverseDamping& damping);

  /// x (n) = J+ b.
  void apply(const Vec6& b, JointVector& x) const;

  double manipulability() const { return manipulability_; }
  bool damped() const { return damped_; }

 private:
  const Jacobian* J_ = nullptr;
  Eigen::PartialPivLU<Eigen::Matrix<double, 6, 6>> lu_;
  Eigen::LLT<Eigen::Matrix<double, 6, 6>> llt_;
  double manipulability_ = 0.0;
  bool damped_ = false;
};

}  // namespace armtune
