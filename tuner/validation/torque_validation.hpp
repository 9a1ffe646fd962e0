#pragma once
// Answers whether a robot model explains the torques of a log, joint by joint, and what is wrong with the
// model or the log if it does not:
//
//     const TorqueValidation found = validate_torques(*load_robot("ur5e"), log);
//     for (const std::string& sentence : sentences(found, model)) ...

#include <string>
#include <vector>

#include "tuner/validation/log_checks.hpp"

namespace armtune::internal {

struct TorqueValidation {
  ValidationThresholds thresholds;
  double cutoff = 0.0;                        ///< of the filter that torques and model have passed [Hz]
  std::vector<VelocityAgreement> velocities;  ///< n
  TorqueResiduals residuals;
  Misfit misfit;
  std::vector<LogFinding> findings;  ///< empty: the log is plausible
  std::vector<bool> matches;         ///< n; true if the model matches the joint (matching_joints)
  TorqueRows rows;                   ///< measured and predicted torques over time, for plots

  bool model_matches() const;
};

/// Compares a log with the unfitted model. Throws InputError if the log is malformed or too short,
/// and with the key `torque` if it has no torques.
TorqueValidation validate_torques(const RobotModel& model, const JointLog& log,
                                  const ValidationThresholds& thresholds = {},
                                  double cutoff = kValidationCutoff);

/// Returns one sentence for each finding about the log, then one for each joint.
std::vector<std::string> sentences(const TorqueValidation& found, const RobotModel& model);

}  // namespace armtune::internal
