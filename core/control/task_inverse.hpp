#pragma once
// Computes the inverse J+ of the tool's Jacobian J. The inverse is damped if the manipulability m =
// sqrt(det(J J^T)) is below a threshold (equations 3 and 4 in NOTATION.md):
//   - m at or above the threshold: J+ = J^-1 with six joints, and J+ = J^T (J J^T)^-1 with more.
//   - m below the threshold: J+ = J^T (J J^T + psi I)^-1, where psi is the damping.
// For a task with fewer components (core/control/task_mask.hpp), E J replaces J. The matrix E selects the
// components of the task: the three linear ones, or these and the angular ones about the tool's x and y axes.

#include "core/common/cholesky6.hpp"
#include "core/common/lu6.hpp"
#include "core/common/products.hpp"
#include "core/control/inverse_damping.hpp"
#include "core/control/task_mask.hpp"

namespace armtune::internal {

template <typename T>
class TaskInverseT {
 public:
  /// Factorises the matrices once for all right-hand sides of a control period. J (6 x n) is not copied and
  /// must remain valid. With fewer joints than task components, J J^T is always singular. The inverse is then
  /// always damped with the full psi, and m = sqrt(det(J^T J)). R_0T: orientation of the tool.
  void compute(const JacobianT<T>& J, const InverseDampingT<T>& damping, TaskMask mask = TaskMask::kPose,
               const Mat3T<T>& R_0T = Mat3T<T>::Identity()) {
    J_ = &J;
    mask_ = mask;
    const int rows = components(mask);
    const auto n = static_cast<int>(J.cols());
    if (mask_ == TaskMask::kPositionAndAxis) {
      R_0T_ = R_0T;
      taken_.resize(6, n);
      for (int i = 0; i < n; ++i) taken_.col(i) = take(Vec6T<T>(J.col(i)));
    }
    const bool deficient = n < rows;
    if (is_square()) {
      lu_.compute(J);
      manipulability_ = lu_.absolute_determinant();
    } else if (deficient) {
      cholesky_.compute(Jt_J(), n);
      manipulability_ = cholesky_.root_of_determinant();
    } else {
      cholesky_.compute(J_Jt(T(0)), rows);
      manipulability_ = cholesky_.root_of_determinant();
    }
    const T& m = manipulability_;
    // Not "m < threshold": a manipulability of NaN is damped as well.
    undamped_ = deficient ? MaskT<T>{} : m >= damping.threshold;
    some_damped_ = !all(undamped_);
    if (some_damped_) damped_.compute(J_Jt(deficient ? damping.psi : damping.at(m)), rows);
  }

  /// Computes x = J+ b (n). Without damping, x is the smallest vector for which J x equals b in the
  /// components of the task.
  void apply(const Vec6T<T>& b, JointVectorT<T>& x) const {
    if (!is_square()) return transposed_times(*J_, multipliers(b), x);
    if (any(undamped_)) lu_.solve(b, x);
    if (!some_damped_) return;
    JointVectorT<T> damped;
    transposed_times(*J_, damped_.solve(b), damped);
    if (x.size() != damped.size()) x = damped;
    for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = select(undamped_, x[i], damped[i]);
  }

  /// Returns L = E^T (E J J^T E^T)^-1 E b, damped like the inverse, so that J+ b = J^T L. It must not be
  /// called if is_square().
  Vec6T<T> multipliers(const Vec6T<T>& b) const {
    const Vec6T<T> taken = take(b);
    if (!some_damped_) return give(cholesky_.solve(taken));
    Vec6T<T> L = damped_.solve(taken);
    if (any(undamped_)) {
      const Vec6T<T> exact = cholesky_.solve(taken);
      for (int row = 0; row < 6; ++row) L[row] = select(undamped_, exact[row], L[row]);
    }
    return give(L);
  }

  /// Returns E^T E b, the part of b that belongs to the task.
  Vec6T<T> of_task(const Vec6T<T>& b) const { return give(take(b)); }

  /// True for six joints and six task components.
  bool is_square() const { return mask_ == TaskMask::kPose && J_->cols() == 6; }
  TaskMask mask() const { return mask_; }
  const T& manipulability() const { return manipulability_; }
  MaskT<T> damped() const { return undamped_ == MaskT<T>{}; }

 private:
  using Mat6 = typename Cholesky6T<T>::Matrix;

  /// Returns E b in the leading rows, with zeros below.
  Vec6T<T> take(const Vec6T<T>& b) const {
    if (mask_ == TaskMask::kPose) return b;
    Vec6T<T> taken = Vec6T<T>::Zero();
    taken.template head<3>() = b.template head<3>();
    if (mask_ == TaskMask::kPositionAndAxis) {
      taken[3] = dot3(R_0T_.col(0), b.template tail<3>());
      taken[4] = dot3(R_0T_.col(1), b.template tail<3>());
    }
    return taken;
  }
  /// Returns E^T times the leading rows.
  Vec6T<T> give(const Vec6T<T>& taken) const {
    if (mask_ == TaskMask::kPose) return taken;
    Vec6T<T> b = Vec6T<T>::Zero();
    b.template head<3>() = taken.template head<3>();
    if (mask_ == TaskMask::kPositionAndAxis) {
      b.template tail<3>() = R_0T_.col(0) * taken[3] + R_0T_.col(1) * taken[4];
    }
    return b;
  }

  /// Returns E J. Rows beyond the task's components are not used.
  const JacobianT<T>& task_jacobian() const { return mask_ == TaskMask::kPositionAndAxis ? taken_ : *J_; }
  /// Returns E J J^T E^T + psi I. Only the lower triangle of the leading rows is set.
  Mat6 J_Jt(const T& psi) const {
    const JacobianT<T>& J = task_jacobian();
    Mat6 A;
    for (int row = 0; row < components(mask_); ++row) {
      for (int column = 0; column <= row; ++column) {
        T sum = J(row, 0) * J(column, 0);
        for (Eigen::Index i = 1; i < J.cols(); ++i) sum += J(row, i) * J(column, i);
        A(row, column) = sum;
      }
      A(row, row) += psi;
    }
    return A;
  }
  /// Returns the leading n rows of J^T E^T E J. Only their lower triangle is set.
  Mat6 Jt_J() const {
    const JacobianT<T>& J = task_jacobian();
    Mat6 A;
    for (int row = 0; row < J.cols(); ++row) {
      for (int column = 0; column <= row; ++column) {
        T sum = J(0, row) * J(0, column);
        for (int i = 1; i < components(mask_); ++i) sum += J(i, row) * J(i, column);
        A(row, column) = sum;
      }
    }
    return A;
  }

  const JacobianT<T>* J_ = nullptr;
  TaskMask mask_ = TaskMask::kPose;
  Mat3T<T> R_0T_ = Mat3T<T>::Identity();
  JacobianT<T> taken_;  ///< E J for kPositionAndAxis
  Lu6T<T> lu_;
  Cholesky6T<T> cholesky_;
  Cholesky6T<T> damped_;
  T manipulability_{0.0};
  MaskT<T> undamped_{};
  bool some_damped_ = false;
};
using TaskInverse = TaskInverseT<double>;

}  // namespace armtune::internal
