#pragma once
// When and how strongly the inverse of the Jacobian is damped.
//
// Switched on as a whole, psi lets the joint reference jump where the manipulability m passes the threshold.
// Variable, it grows from zero there, psi (1 - m/threshold)^2 (Nakamura, Hanafusa, Inverse kinematic
// solutions with singularity robustness for robot manipulator control, 1986).

namespace armtune {

struct InverseDamping {
  double threshold = 0.0;  ///< manipulability below which it is damped [m^3]
  double psi = 0.0;        ///< [m^2]
  bool variable = false;   ///< psi grows from zero at the threshold; otherwise it is there at once

  /// psi at a manipulability below the threshold.
  double at(double manipulability) const {
    const double below = variable ? 1.0 - manipulability / threshold : 1.0;
    return psi * below * below;
  }
};

}  // namespace armtune
