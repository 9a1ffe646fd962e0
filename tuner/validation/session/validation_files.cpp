#include "tuner/validation/session/validation_files.hpp"

#include <fmt/format.h>

#include <cmath>

#include "sim/csv/cell.hpp"

namespace armtune::internal {
namespace {

/// Returns the header cells of every joint, such as "joint/elbow/rms".
std::string joint_header(const RobotModel& model, std::initializer_list<const char*> columns) {
  std::string text;
  for (const JointInfo& joint : model.joints) {
    for (const char* column : columns) text += "," + cell(fmt::format("joint/{}/{}", joint.name, column));
  }
  return text + "\n";
}

std::optional<double> if_finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string name_of(const RobotModel& model, int joint) {
  return joint < 0 ? std::string() : model.joints[static_cast<std::size_t>(joint)].name;
}

LogFindingFact fact_of(const LogFinding& finding, const RobotModel& model) {
  LogFindingFact fact;
  fact.kind = kind_of(finding);
  fact.joint = name_of(model, finding.joint);
  fact.other = name_of(model, finding.other);
  if (finding.value != 0.0) fact.value = if_finite(finding.value);
  if (finding.time != 0.0) fact.time = if_finite(finding.time);
  fact.text = to_text(finding, model);
  return fact;
}

std::vector<MisfitCauseFact> misfit_facts(const Misfit& misfit, const RobotModel& model) {
  std::vector<MisfitCauseFact> facts;
  for (const MisfitCause& cause : misfit.causes)
    facts.push_back({name(cause.kind), name_of(model, cause.joint), cause.value, cause.share.maxCoeff()});
  return facts;
}

}  // namespace

std::string residuals_csv(const RobotModel& model, const TorqueRows& rows) {
  std::string text = "time" + joint_header(model, {"measured", "predicted", "residual"});
  for (Eigen::Index i = 0; i < rows.count(); ++i) {
    text += cell(rows.time[static_cast<std::size_t>(i)]);
    for (const Eigen::MatrixXd& joint : rows.joint) {
      const double measured = joint(i, kMeasuredTorque);
      const double predicted = joint(i, kPredictedTorque);
      text += fmt::format(",{},{},{}", cell(measured), cell(predicted), cell(measured - predicted));
    }
    text += '\n';
  }
  return text;
}

std::string horizons_csv(const RobotModel& model, const MotionValidation& motion) {
  std::string text = "horizon,windows" + joint_header(model, {"rms", "low", "high", "yardstick"});
  for (std::size_t h = 0; h < motion.horizons.size(); ++h) {
    text += fmt::format("{},{}", cell(motion.horizons[h]), motion.count[h]);
    for (const HorizonCurve& joint : motion.joint) {
      for (const double value : {joint.rms[h], joint.low[h], joint.high[h], joint.yardstick(h)})
        text += "," + cell(value);
    }
    text += '\n';
  }
  return text;
}

ValidationFacts validation_facts(const RobotModel& model, const LoggedJoints& logged,
                                 const LogValidation& found) {
  ValidationFacts facts;
  facts.matches = found.matches();
  facts.headline = headline(found, model);
  facts.robot = model.name;
  facts.samples = logged.log.samples();
  facts.duration = logged.log.time.back() - logged.log.time.front();
  if (found.motion) facts.commands = name(found.motion->kind);
  for (int j = 0; j < model.n(); ++j) {
    JointMatchFact& joint = facts.joints.emplace_back();
    joint.joint = model.joints[static_cast<std::size_t>(j)].name;
    joint.matches = found.matches(j);
    if (found.torques) {
      const JointResidual& residual = found.torques->residuals.joint[static_cast<std::size_t>(j)];
      joint.explained = if_finite(residual.explained);
      joint.residual_rms = if_finite(residual.rms);
      joint.torque_rms = if_finite(residual.torque_rms);
    }
    if (found.motion) joint.motion = if_finite(found.motion->excess[static_cast<std::size_t>(j)]);
  }
  facts.causes = cause_sentences(found, model);
  if (found.torques) facts.misfit = misfit_facts(found.torques->misfit, model);
  for (const LogFinding& finding : found.findings) facts.findings.push_back(fact_of(finding, model));
  facts.not_compared = found.not_compared;
  facts.notes = logged.notes;
  for (const ValidationThresholdField& field : validation_threshold_fields())
    facts.thresholds.push_back({field.name, found.thresholds.*field.value});
  return facts;
}

}  // namespace armtune::internal
