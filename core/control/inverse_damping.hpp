#pragma once
// When and how strongly the inverse of the Jacobian is damped.
//
// Switched on as a whole, psi lets the joint reference jump where the manipulability m passes the threshold.
// Variable, it grows from zero there, psi (1 - m/threshold)^2 (Nakamura, Hanafusa, Inverse kinematic
// solutions with singularity robustness for robot manipulator control, 1986).

namespace armtune::internal {

template <typename T>
struct InverseDampingT {
  T threshold{0.0};  ///< manipulability below which it is damped [m^3]
  T psi{0.0};        ///< [m^2]
  T growing{0.0};    ///< 1: psi grows from zero at the threshold; 0: it is there at once

  /// psi at a manipulability below the threshold.
  T at(const T& manipulability) const {
    const T below = T(1) - growing * (manipulability / threshold);
    return psi * below * below;
  }
};
using InverseDamping = InverseDampingT<double>;

}  // namespace armtune::internal
