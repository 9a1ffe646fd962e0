#include "tuner/validation/torque_validation.hpp"

#include <algorithm>

#include "armtune/error.hpp"
#include "tuner/validation/misfit_text.hpp"

namespace armtune::internal {

bool TorqueValidation::model_matches() const {
  return std::all_of(matches.begin(), matches.end(), [](bool match) { return match; });
}

TorqueValidation validate_torques(const RobotModel& model, const JointLog& log,
                                  const ValidationThresholds& thresholds, double cutoff) {
  if (!log.has_torques()) {
    throw InputError(InputPlace{log.source, 0, "torque"},
                     {"the log has no torques, which the model could be compared with; log them",
                      "no torques", "a torque for each joint"});
  }
  TorqueValidation found;
  found.thresholds = thresholds;
  const LoggedMotion motion = joint_motion(model, log, thresholds, cutoff);
  found.cutoff = motion.cutoff;
  found.velocities = motion.velocities;
  found.rows = torque_rows(model, motion);
  found.residuals = torque_residuals(found.rows, thresholds);
  found.matches = matching_joints(model, found.residuals, thresholds);
  found.misfit = misfit_causes(model, found.rows, thresholds);
  found.findings = log_findings(model, log, motion, found.rows, found.misfit, thresholds);
  return found;
}

std::vector<std::string> sentences(const TorqueValidation& found, const RobotModel& model) {
  std::vector<std::string> all;
  for (const LogFinding& finding : found.findings) all.push_back(to_text(finding, model));
  for (int j = 0; j < model.n(); ++j) {
    all.push_back(joint_text(model, j, found.residuals.joint[static_cast<std::size_t>(j)], found.misfit,
                             found.thresholds.cause_share));
  }
  return all;
}

}  // namespace armtune::internal
