#include "tuner/calibration/session/calibration_tables.hpp"

#include <fmt/format.h>

#include <cmath>

#include "sim/csv/cell.hpp"

namespace armtune::internal {

std::string unit_of(const RobotModel& model, const CalibrationParameter& parameter) {
  const std::size_t comma = parameter.unit.find(", ");
  if (comma == std::string::npos || parameter.joint < 0) return parameter.unit;
  const bool turns = model.chain.motion[static_cast<std::size_t>(parameter.joint)] == JointMotion::kRevolute;
  return turns ? parameter.unit.substr(0, comma) : parameter.unit.substr(comma + 2);
}

std::string parameters_csv(const RobotModel& model, const Calibration& found) {
  std::string text = "parameter,unit,before,after,low,high,spread,told,kept,needs,motion\n";
  for (const FittedParameter& p : found.parameters) {
    text += fmt::format("{},{},{},{},{},{},{},{:d},{:d},{},{}\n", cell(p.prior.name),
                        cell(unit_of(model, p.prior)), cell(p.prior.nominal), cell(p.value), cell(p.low),
                        cell(p.high), cell(p.spread), p.told, p.kept, p.told ? "" : name(p.need),
                        p.told ? "" : cell(std::string(meaning(p.need))));
  }
  return text;
}

std::string held_out_csv(const RobotModel& model, const Calibration& found) {
  std::string text = "horizon,windows";
  for (const JointInfo& joint : model.joints) {
    for (const char* column : {"before", "after"})
      text += "," + cell(fmt::format("joint/{}/{}", joint.name, column));
  }
  text += '\n';
  for (std::size_t h = 0; h < kReportedHorizons.size(); ++h) {
    const auto row = static_cast<Eigen::Index>(h);
    text += fmt::format("{},{}", cell(kReportedHorizons[h]), found.before.windows[h]);
    for (Eigen::Index j = 0; j < model.n(); ++j)
      text += fmt::format(",{},{}", cell(found.before.rms(row, j)), cell(found.after.rms(row, j)));
    text += '\n';
  }
  return text;
}

CalibrationFacts calibration_facts(const RobotModel& model, const Calibration& found) {
  const HeldOutGain gain = held_out_gain(found);
  CalibrationFacts facts;
  facts.better = gain.better();
  facts.headline = headline(found);
  facts.robot = model.name;
  facts.commands = name(found.commands);
  facts.horizon = gain.horizon;
  facts.windows = gain.windows;
  if (std::isfinite(gain.ratio)) facts.error_ratio = gain.ratio;
  facts.parameters = static_cast<long>(found.parameters.size());
  for (const FittedParameter& p : found.parameters)
    if (!p.told) facts.not_told.push_back({p.prior.name, name(p.need)});
  facts.cautions = caution_sentences(found);
  return facts;
}

}  // namespace armtune::internal
