#pragma once
// The damping psi in the inverse J^T (J J^T + psi I)^-1 of the Jacobian. It bounds the joint velocities near
// singularities.
//
// If the damping psi is switched on at once, the joint reference jumps when the manipulability m passes the
// threshold. Variable damping grows from zero at the threshold: psi * (1 - m/threshold)^2 (Nakamura,
// Hanafusa, Inverse kinematic solutions with singularity robustness for robot manipulator control, 1986).

namespace armtune::internal {

template <typename T>
struct InverseDampingT {
  T threshold{0.0};  ///< manipulability below which the inverse is damped [m^3]
  T psi{0.0};        ///< [m^2]
  T growing{0.0};    ///< 1: the damping grows from zero at the threshold; 0: it is psi everywhere below

  /// Returns the damping at a manipulability below the threshold.
  T at(const T& manipulability) const {
    const T below = T(1) - growing * (manipulability / threshold);
    return psi * below * below;
  }
};
using InverseDamping = InverseDampingT<double>;

}  // namespace armtune::internal
