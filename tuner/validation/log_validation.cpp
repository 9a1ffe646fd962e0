#include "tuner/validation/log_validation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "armtune/error.hpp"
#include "tuner/validation/misfit_text.hpp"

namespace armtune::internal {
namespace {

const std::string& joint_called(const RobotModel& model, std::size_t joint) {
  return model.joints[joint].name;
}

/// Returns the joint whose torque is explained least; of those that do not match, if there are any.
std::size_t least_explained(const TorqueValidation& torques) {
  const bool all = torques.model_matches();
  std::size_t least = torques.matches.size();
  for (std::size_t j = 0; j < torques.matches.size(); ++j) {
    if (!all && torques.matches[j]) continue;
    if (least == torques.matches.size() ||
        torques.residuals.joint[j].explained < torques.residuals.joint[least].explained)
      least = j;
  }
  return least;
}

std::string torque_clause(const TorqueValidation& torques, const RobotModel& model) {
  const std::size_t worst = least_explained(torques);
  // Rounded down, because "at least 100 %" would be wrong; never -0.
  const double percent = std::floor(1000.0 * torques.residuals.joint[worst].explained) / 10.0 + 0.0;
  if (!torques.model_matches()) {
    const auto wrong = std::count(torques.matches.begin(), torques.matches.end(), false);
    return fmt::format("the torques of {} of {} joints differ, most of all {} ({:.1f} % explained)", wrong,
                       torques.matches.size(), joint_called(model, worst), percent);
  }
  if (torques.residuals.joint[worst].explained >= torques.thresholds.explained)
    return fmt::format("at least {:.1f} % of each joint's torque variance is explained", percent);
  return fmt::format("the torques are explained, or differ by a negligible amount as in {}",
                     joint_called(model, worst));
}

std::string motion_clause(const MotionValidation& motion, const RobotModel& model) {
  const auto worst = static_cast<std::size_t>(motion.worst_joint());
  const std::size_t at = motion.index_of(motion.judged);
  const auto differs = std::count_if(motion.excess.begin(), motion.excess.end(),
                                     [](double excess) { return !(excess <= 1.0); });
  const std::string error =
      fmt::format("{}, {:.2g} {} after {:.2g} s", joint_called(model, worst), motion.joint[worst].rms[at],
                  model.chain.motion[worst] == JointMotion::kRevolute ? "rad" : "m", motion.judged);
  if (motion.model_matches()) return "the simulated motion stays near the logged one (worst: " + error + ")";
  if (differs == 0)
    return fmt::format("{} of {} simulated windows diverge", motion.failed, motion.windows.size());
  return fmt::format("the simulated motion of {} of {} joints leaves the logged one, most of all {}", differs,
                     motion.excess.size(), error);
}

/// Simulates the motion, or says why it cannot be.
void simulate_motion(const RobotModel& model, const LoggedJoints& logged, LogValidation& found) {
  if (!logged.commands) {
    found.not_compared.emplace_back(
        "motion was not simulated ahead: the log has no commands that were found; record the commands of the "
        "controller beside the joints");
    return;
  }
  try {
    found.motion = validate_motion(model, logged.log, *logged.commands, found.thresholds);
  } catch (const InputError& error) {
    found.not_compared.push_back(fmt::format("motion was not simulated ahead: {}", error.what()));
  }
}

}  // namespace

bool LogValidation::matches() const {
  if (!torques && !motion) return findings.empty();
  return (!torques || torques->model_matches()) && (!motion || motion->model_matches());
}

bool LogValidation::matches(int joint) const {
  const auto j = static_cast<std::size_t>(joint);
  return (!torques || torques->matches[j]) && (!motion || motion->excess[j] <= 1.0);
}

LogValidation validate_log(const RobotModel& model, const LoggedJoints& logged,
                           const ValidationThresholds& thresholds) {
  LogValidation found;
  found.thresholds = thresholds;
  if (logged.log.has_torques()) {
    found.torques = validate_torques(model, logged.log, thresholds);
    found.findings = found.torques->findings;
  } else {
    found.findings =
        motion_findings(model, logged.log, joint_motion(model, logged.log, thresholds), thresholds);
    found.not_compared.emplace_back(
        "torques were not compared: the log has none for each joint; record measured torques, or currents "
        "with a column map");
  }
  simulate_motion(model, logged, found);
  return found;
}

std::string headline(const LogValidation& found, const RobotModel& model) {
  const std::string about_log =
      found.findings.empty() ? ""
                             : fmt::format("; {} about the log itself",
                                           found.findings.size() == 1
                                               ? "there is a finding"
                                               : fmt::format("there are {} findings", found.findings.size()));
  if (!found.torques && !found.motion) {
    return fmt::format("The log has neither torques nor commands to compare {} with{}", model.name,
                       found.findings.empty() ? "; its positions and velocities are plausible" : about_log);
  }
  std::vector<std::string> clauses;
  if (found.torques) clauses.push_back(torque_clause(*found.torques, model));
  if (found.motion) clauses.push_back(motion_clause(*found.motion, model));
  return fmt::format("The model of {} {} the log: {}{}", model.name,
                     found.matches() ? "matches" : "does not match", fmt::join(clauses, "; "), about_log);
}

std::vector<std::string> cause_sentences(const LogValidation& found, const RobotModel& model) {
  std::vector<std::string> all;
  if (found.torques) {
    const std::vector<MisfitCause>& causes = found.torques->misfit.causes;
    for (int j = 0; j < model.n(); ++j) {
      const bool has_cause = std::any_of(causes.begin(), causes.end(), [&](const MisfitCause& cause) {
        return (cause.joint < 0 || cause.joint == j) && cause.share[j] >= found.thresholds.cause_share;
      });
      if (found.torques->matches[static_cast<std::size_t>(j)] && !has_cause) continue;
      all.push_back(joint_text(model, j, found.torques->residuals.joint[static_cast<std::size_t>(j)],
                               found.torques->misfit, found.thresholds.cause_share));
    }
  }
  if (found.motion) {
    for (std::string& sentence : sentences(*found.motion, model)) all.push_back(std::move(sentence));
  }
  return all;
}

std::vector<std::string> finding_sentences(const LogValidation& found, const RobotModel& model) {
  std::vector<std::string> all;
  for (const LogFinding& finding : found.findings) all.push_back(to_text(finding, model));
  return all;
}

}  // namespace armtune::internal
