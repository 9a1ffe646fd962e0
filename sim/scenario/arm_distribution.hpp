#pragma once
// A joint normal distribution of what is not known of an arm: friction, rotor inertia, gains of its drives,
// delay, payload, tilt of its base and offsets of its encoders. A calibration writes it as uncertainty.yaml.
// Random arms can be drawn from it instead of from independent uniform distributions (perturbation.hpp).
//
//     const auto distribution = load_arm_distribution("uncertainty.yaml", {&scenario, 1});
//     const Eigen::VectorXd values = drawn_parameters(*distribution, 1, 7);  // arm 7 of seed 1
//     give_parameters(*distribution, values, scenario);

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

enum class ArmParameterKind {
  kViscousFriction,
  kCoulombFriction,
  kRotorInertia,
  kVelocityGain,    ///< of the drives (velocity_drive.hpp)
  kIntegralGain,    ///< likewise
  kPositionGain,    ///< of the loops in front of the drives (joint_drives.hpp)
  kTorqueFactor,    ///< true torque per commanded torque; arms are not drawn with it
  kDelay,           ///< from a command to its effect
  kPayloadMass,     ///< point mass at the tool
  kPayloadCenterX,  ///< of this point mass, tool frame
  kPayloadCenterY,
  kPayloadCenterZ,
  kTiltX,  ///< angle of the base about its own x axis
  kTiltY,
  kEncoderOffset  ///< true minus measured position
};

struct ArmParameter {
  ArmParameterKind kind = ArmParameterKind::kDelay;
  int joint = -1;            ///< -1: of the whole arm
  std::string name;          ///< such as "elbow_joint/viscous_friction" or "payload/mass"
  bool logarithmic = false;  ///< true: the logarithm of the value is normal, so that the value is positive
  double mean = 0.0;         ///< of the value, or of its natural logarithm; SI units
  bool told = true;  ///< false: no log told it, so it varies about as widely as before the calibration
  /// Value in the robot file that the calibration wrote. None: not in a robot file, or not known.
  std::optional<double> robot_file;

  /// True if simulated arms can differ in it.
  bool is_drawn() const { return kind != ArmParameterKind::kTorqueFactor; }
};

struct ArmDistribution {
  std::string file;  ///< path
  std::string note;  ///< what the file says about the whole distribution; may be empty
  std::vector<ArmParameter> parameters;
  Eigen::MatrixXd covariance;  ///< of the values or their logarithms, in the order of the parameters
  Eigen::MatrixXd factor;      ///< lower triangular L with L L' = covariance
};

/// Reads a distribution for the arm of the scenarios. Throws InputError with file, line and key if
///   - a name is unknown, belongs to no joint of the arm, or occurs twice;
///   - a parameter that must be positive is not logarithmic;
///   - the covariance has the wrong size, or is not symmetric and positive semidefinite;
///   - the file was written for another robot file than that of a scenario, because values differ;
///   - the scenarios have arms with different joints.
std::shared_ptr<const ArmDistribution> load_arm_distribution(const std::string& path,
                                                             std::span<const Scenario> scenarios);

/// Returns the values of all parameters for one arm, x = mean + L z and exp(x) where a logarithm is normal.
/// The standard normal numbers z are drawn by mt19937_64 and depend on (seed, sample) alone.
Eigen::VectorXd drawn_parameters(const ArmDistribution& distribution, std::uint64_t seed,
                                 std::uint64_t sample);

/// Gives the simulated arm of a scenario these values; parameters that are not drawn are ignored. The
/// controller's model of the arm does not change.
///   - Friction replaces that of the model and of the scenario's `plant`. Payload is added to the scenario's.
///   - If the payload in the robot file is known, the drawn payload takes its place.
///   - The delay replaces the scenario's, rounded to whole control periods.
///   - Negative masses and delays act as zero.
///   - With an offset, the encoders, not the joints, are at the scenario's start position.
void give_parameters(const ArmDistribution& distribution, const Eigen::VectorXd& values, Scenario& scenario);

/// Returns the vector of the model that has a parameter of this kind for each joint. Null: there is none.
JointVector* joint_values_of(ArmParameterKind kind, RobotModel& model);

/// Returns a copy of the model that has gains for all its drives. Gains that it lacks get the defaults of
/// velocity_drive.hpp and joint_drives.hpp.
RobotModel with_drive_gains(const RobotModel& model);

}  // namespace armtune::internal
