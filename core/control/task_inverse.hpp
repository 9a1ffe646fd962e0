#pragma once
// The manipulability-switched inverse of the Jacobian (equations 3 and 4):
//   m = sqrt(det(J J^T));  m >= threshold: J^-1, or J^T (J J^T)^-1 with more than six joints;
//   otherwise the damped J^T (J J^T + psi I)^-1.

#include "core/common/cholesky6.hpp"
#include "core/common/lu6.hpp"
#include "core/common/products.hpp"
#include "core/control/inverse_damping.hpp"

namespace armtune {

template <typename T>
class TaskInverseT {
 public:
  /// Factorises once for all right-hand sides of a control period. J is 6 x n and is referred to, not copied.
  /// With fewer than six joints J J^T is singular by shape: always damped with all of psi,
  /// m = sqrt(det(J^T J)).
  void compute(const JacobianT<T>& J, const InverseDampingT<T>& damping) {
    J_ = &J;
    const auto n = static_cast<int>(J.cols());
    if (n == 6) {
      lu_.compute(J);
      manipulability_ = lu_.absolute_determinant();
    } else if (n > 6) {
      cholesky_.compute(J_Jt(T(0)), 6);
      manipulability_ = cholesky_.root_of_determinant();
    } else {
      cholesky_.compute(Jt_J(), n);
      manipulability_ = cholesky_.root_of_determinant();
    }
    const T& m = manipulability_;
    // Not "below": a manipulability that is no number is damped as well.
    undamped_ = n < 6 ? MaskT<T>{} : m >= damping.threshold;
    some_damped_ = !all(undamped_);
    if (some_damped_) damped_.compute(J_Jt(n < 6 ? damping.psi : damping.at(m)), 6);
  }

  /// x (n) = J+ b.
  void apply(const Vec6T<T>& b, JointVectorT<T>& x) const {
    if (any(undamped_)) {
      if (J_->cols() == 6) {
        lu_.solve(b, x);
      } else {
        transposed_times(*J_, cholesky_.solve(b), x);
      }
    }
    if (!some_damped_) return;
    JointVectorT<T> damped;
    transposed_times(*J_, damped_.solve(b), damped);
    if (x.size() != damped.size()) x = damped;
    for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = select(undamped_, x[i], damped[i]);
  }

  const T& manipulability() const { return manipulability_; }
  MaskT<T> damped() const { return undamped_ == MaskT<T>{}; }

 private:
  using Mat6 = typename Cholesky6T<T>::Matrix;

  /// J J^T + psi I, of which the lower triangle is set.
  Mat6 J_Jt(const T& psi) const {
    const JacobianT<T>& J = *J_;
    Mat6 A;
    for (int row = 0; row < 6; ++row) {
      for (int column = 0; column <= row; ++column) {
        T sum = J(row, 0) * J(column, 0);
        for (Eigen::Index i = 1; i < J.cols(); ++i) sum += J(row, i) * J(column, i);
        A(row, column) = sum;
      }
      A(row, row) += psi;
    }
    return A;
  }
  /// The leading n rows of J^T J, likewise.
  Mat6 Jt_J() const {
    const JacobianT<T>& J = *J_;
    Mat6 A;
    for (int row = 0; row < J.cols(); ++row) {
      for (int column = 0; column <= row; ++column) {
        T sum = J(0, row) * J(0, column);
        for (int i = 1; i < 6; ++i) sum += J(i, row) * J(i, column);
        A(row, column) = sum;
      }
    }
    return A;
  }

  const JacobianT<T>* J_ = nullptr;
  Lu6T<T> lu_;
  Cholesky6T<T> cholesky_;
  Cholesky6T<T> damped_;
  T manipulability_{0.0};
  MaskT<T> undamped_{};
  bool some_damped_ = false;
};
using TaskInverse = TaskInverseT<double>;

}  // namespace armtune
