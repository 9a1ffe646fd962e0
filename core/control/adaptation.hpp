#pragma once
// Online adaptation of the parameters theta of the controller's arm model (equations 5 and 6 in NOTATION.md):
//   theta <- theta - gamma Y^T S dt,   S = q' - qr'.
// The law compensates the arm's dynamics with the torque Y theta, where Y is the regressor of slotine_li.hpp.
// The scalar type T is double for one arm, or a SIMD type for several arms at once (core/common/pack.hpp).
//
// The published law (NOTATION.md) computes Y from the measured motion, Y(q, q', qr', qr''). S contains the
// noise e of the measured velocities. The reference acceleration qr'' contains it too, because it contains
// the feedback -Kp e. S and Y are then correlated, so the inertia estimates grow without end, by gamma Kp
// E[e^2] per second, where E[e^2] is the variance of the noise. Three options limit this drift of theta; the
// published law has none of them:
//   - Y is computed from the filtered motion (adaptation_filter.hpp), which has hardly any noise.
//   - Leakage moves theta towards its start values, faster for inertias than for the other parameters. Noise
//     mainly increases the estimates of inertias, and an overestimated inertia of a light wrist makes the
//     loop oscillate. Masses and first moments need only slow leakage, because gravity excites them at all
//     times and wrong estimates are corrected. Theta therefore keeps what was learnt about a payload.
//   - Projection moves theta to physically valid parameters. It bounds theta from one side only: the cone of
//     physical parameters has no upper bound.

#include "core/common/select.hpp"
#include "core/robot/physical_theta.hpp"
#include "core/robot/slotine_li.hpp"
#include "core/robot/theta.hpp"

namespace armtune::internal {

template <typename T>
class AdaptationT {
 public:
  AdaptationT() = default;
  explicit AdaptationT(const ParameterVectorT<T>& theta) : start_(theta), theta_(theta), gradient_(theta) {}

  const ParameterVectorT<T>& theta() const { return theta_; }
  ParameterVectorT<T>& theta() { return theta_; }
  /// Returns the start values of theta, to which leakage moves the estimates back.
  ParameterVectorT<T>& start() { return start_; }

  /// Takes one explicit Euler step of length dt [s] for the arms that `where` selects. Y is computed from the
  /// motion `along`, and S from the motion `measured`. Both motions must belong to the present control
  /// period.
  void step(const SlotineLiT<T>& along, const SlotineLiT<T>& measured, const T& gamma, const T& dt,
            const MaskT<T>& where = T(0) < T(1)) {
    slotine_li_gradient(along, measured, gradient_);
    const T rate = gamma * dt;
    for (Eigen::Index i = 0; i < theta_.size(); ++i) {
      theta_[i] = select(where, theta_[i] - rate * gradient_[i], theta_[i]);
    }
  }

  /// Applies leakage (Ioannou and Kokotovic's sigma modification):
  ///   theta <- theta - rate * (theta - start) * dt.
  /// The rate is `leakage`; for the inertias of links and rotors it is `leakage` + `of_inertias` [1/s].
  void leak(const T& leakage, const T& of_inertias, const T& dt, const MaskT<T>& where = T(0) < T(1)) {
    const T slow = leakage * dt;
    const T fast = (leakage + of_inertias) * dt;
    const auto n = static_cast<int>(theta_.size() / (kLinkParameters + kJointParameters));
    const auto decay = [&](Eigen::Index i, const T& rate) {
      theta_[i] = select(where, theta_[i] - rate * (theta_[i] - start_[i]), theta_[i]);
    };
    for (int link = 0; link < n; ++link) {
      const int first = link * kLinkParameters;
      for (int k = 0; k < kLinkParameters; ++k) decay(first + k, k < kFirstInertia ? slow : fast);
      const int joint = joint_parameter_index(n, link);
      for (int k = 0; k < kJointParameters; ++k) decay(joint + k, k == 0 ? fast : slow);
    }
  }

  /// Moves theta to the nearest physically valid parameters (physical_theta.hpp).
  void project() { project_to_physical(theta_); }

 private:
  ParameterVectorT<T> start_;
  ParameterVectorT<T> theta_;
  ParameterVectorT<T> gradient_;
};
using Adaptation = AdaptationT<double>;

}  // namespace armtune::internal
