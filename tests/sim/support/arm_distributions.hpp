#pragma once
// Texts of small joint distributions for the UR10.

#include <string>

namespace armtune::internal::test {

/// Friction of two joints, payload and delay, all correlated; the first one is not told by a log.
inline const std::string kSmallParameters =
    "parameters:\n"
    "  - {name: elbow_joint/viscous_friction, unit: N m s/rad, logarithm: true, mean: 1.0, told: false}\n"
    "  - {name: wrist_3_joint/coulomb_friction, logarithm: true, mean: -1}\n"
    "  - {name: payload/mass, logarithm: false, mean: 0.5, value: 0.5, interval: [0.46, 0.54]}\n"
    "  - {name: delay, logarithm: false, mean: 0.004}\n";
inline const std::string kSmallCovariance =
    "covariance:\n"
    "  - [0.04]\n"
    "  - [0.01, 0.09]\n"
    "  - [-0.002, 0.003, 0.0004]\n"
    "  - [0.00002, 0, 0.000002, 0.000001]\n";
inline const std::string kSmallDistribution = kSmallParameters + kSmallCovariance;

/// What only drives and sensors see, and the tilt of the base.
inline const std::string kDriveDistribution =
    "parameters:\n"
    "  - {name: shoulder_pan_joint/drive_velocity_gain, logarithm: true, mean: 6}\n"
    "  - {name: elbow_joint/drive_velocity_integral, logarithm: true, mean: 7}\n"
    "  - {name: elbow_joint/drive_position_gain, logarithm: true, mean: 3}\n"
    "  - {name: elbow_joint/encoder_offset, mean: 0.002}\n"
    "  - {name: base/tilt_x, mean: 0.01}\n"
    "  - {name: elbow_joint/rotor_inertia, logarithm: true, mean: -1}\n"
    "  - {name: elbow_joint/torque_factor, logarithm: true, mean: 0}\n"
    "covariance:\n"
    "  - [0.04]\n"
    "  - [0, 0.04]\n"
    "  - [0, 0, 0.01]\n"
    "  - [0, 0, 0, 0.000001]\n"
    "  - [0, 0, 0, 0, 0.0001]\n"
    "  - [0, 0, 0, 0, 0, 0.04]\n"
    "  - [0, 0, 0, 0, 0, 0, 0.04]\n";

}  // namespace armtune::internal::test
