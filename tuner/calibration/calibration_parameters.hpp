#pragma once
// The parameters of an arm that calibration fits, each with its prior distribution. Friction, rotor inertia
// and gains are positive, so their logarithms are fitted. A standardised value z has mean 0 and standard
// deviation 1 under the prior:
//   value = exp(mean + deviation z)   or   value = mean + deviation z.

#include <string>
#include <vector>

#include "tuner/calibration/shooting_arm.hpp"
#include "tuner/validation/motion_commands.hpp"

namespace armtune::internal {

enum class ParameterKind {
  kViscousFriction,
  kCoulombFriction,
  kRotorInertia,
  kVelocityGain,    ///< of the drives (velocity_drive.hpp)
  kIntegralGain,    ///< likewise
  kPositionGain,    ///< of the loops in front of the drives (joint_drives.hpp)
  kTorqueFactor,    ///< true torque per commanded torque: the error of a current constant
  kDelay,           ///< from a logged command to its effect
  kPayloadMass,     ///< point mass at the tool
  kPayloadCenterX,  ///< of this point mass, tool frame
  kPayloadCenterY,
  kPayloadCenterZ,
  kTiltX,  ///< angle of the base about its own x axis
  kTiltY,
  kEncoderOffset  ///< true minus logged position
};

struct CalibrationParameter {
  ParameterKind kind = ParameterKind::kDelay;
  int joint = -1;    ///< -1: of the whole arm
  std::string name;  ///< such as "elbow_joint/viscous_friction" or "payload/mass"
  std::string unit;
  bool logarithmic = false;
  double mean = 0.0;       ///< of the prior: of the value, or of its logarithm
  double deviation = 1.0;  ///< standard deviation of the prior, likewise
  double nominal = 0.0;    ///< value of the robot file

  double value(double z) const;
  /// Returns the derivative of value().
  double slope(double z) const;
};

/// What is fitted, and how wide the priors are. A deviation of 0 leaves the parameters out.
struct CalibrationPriors {
  double known = 1.0;        ///< of the logarithm of friction and rotor inertia that the robot file gives [1]
  double unknown = 1.5;      ///< likewise where the robot file gives none [1]
  double drive_gains = 0.7;  ///< of the logarithm of drive gains [1]
  double torque_factor = 0.0;    ///< of the logarithm of torque factors [1]
  double delay = 0.01;           ///< [s]
  double payload = 0.1;          ///< of the payload's mass, as a share of the mass of all links
  double payload_center = 0.1;   ///< distance of the payload's centre from the tool [m]
  double tilt = 0.02;            ///< [rad]
  double encoder_offset = 0.01;  ///< [rad, m]
};

/// Returns the parameters that have an effect on an arm with commands of this kind.
std::vector<CalibrationParameter> calibration_parameters(const RobotModel& model, CommandKind kind,
                                                         const CalibrationPriors& priors);

/// Returns the arm with the parameters at z, one entry for each. The other parameters are those of `nominal`,
/// which shooting_arm() made.
ShootingArm arm_at(const ShootingArm& nominal, const std::vector<CalibrationParameter>& parameters,
                   const Eigen::VectorXd& z);

}  // namespace armtune::internal
