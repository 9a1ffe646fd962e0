#include "tuner/calibration/calibration_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numbers>

#include "sim/scenario/robot_writer.hpp"
#include "sim/yaml/quoted.hpp"

namespace armtune::internal {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

bool has_kind(const Calibration& found, ParameterKind kind) {
  for (const FittedParameter& p : found.parameters)
    if (p.prior.kind == kind) return true;
  return false;
}

/// True if the calibrated arm has a fitted value of this kind for the joint; -1: for any joint.
bool is_fitted(const Calibration& found, ParameterKind kind, int joint = -1) {
  for (const FittedParameter& p : found.parameters)
    if (p.prior.kind == kind && !p.kept && (joint < 0 || p.prior.joint == joint)) return true;
  return false;
}

/// True if robot.yaml has a value of this kind, or contains it in another one.
bool is_in_robot_file(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::kTorqueFactor:
    case ParameterKind::kDelay:
    case ParameterKind::kTiltX:
    case ParameterKind::kTiltY:
    case ParameterKind::kEncoderOffset:
      return false;
    default:
      return true;
  }
}

}  // namespace

RobotModel calibrated_model(const RobotModel& model, const Calibration& found) {
  RobotModel calibrated = model;
  const RobotModel& fitted = found.arm.model;
  calibrated.chain.viscous_friction = fitted.chain.viscous_friction;
  calibrated.chain.coulomb_friction = fitted.chain.coulomb_friction;
  calibrated.chain.rotor_inertia = fitted.chain.rotor_inertia;
  calibrated.chain.link = fitted.chain.link;
  std::erase_if(calibrated.estimated_rotors, [&](const std::string& joint) {
    return is_fitted(found, ParameterKind::kRotorInertia, model.joint_index(joint));
  });
  // The robot file's mark says nothing about fitted values.
  const auto unmark = [&found](ParameterKind kind, ValueSource& source) {
    if (is_fitted(found, kind)) source = ValueSource::kGiven;
  };
  unmark(ParameterKind::kRotorInertia, calibrated.rotor_source);
  unmark(ParameterKind::kViscousFriction, calibrated.viscous_source);
  unmark(ParameterKind::kCoulombFriction, calibrated.coulomb_source);
  if (has_kind(found, ParameterKind::kVelocityGain)) {
    calibrated.drive_velocity_gain = fitted.drive_velocity_gain;
    calibrated.drive_velocity_integral = fitted.drive_velocity_integral;
  }
  if (has_kind(found, ParameterKind::kPositionGain))
    calibrated.drive_position_gain = fitted.drive_position_gain;
  return calibrated;
}

std::string calibrated_robot_yaml(const RobotModel& model, const Calibration& found,
                                  const std::string& urdf) {
  std::string text = robot_yaml(calibrated_model(model, found), urdf,
                                "Calibrated by armtune; uncertainty.yaml says how well each value is known.");
  text += "# A robot file cannot contain the rest of the calibration:\n";
  text += fmt::format("#   delay from a command to its effect: {:.6g} s\n", found.arm.delay);
  const Vec3 fall = found.arm.model.chain.gravity;
  text += fmt::format("#   gravity in the base frame: [{:.6g}, {:.6g}, {:.6g}] m/s^2\n", fall.x(), fall.y(),
                      fall.z());
  for (int j = 0; j < model.n(); ++j) {
    const bool revolute = model.chain.motion[static_cast<std::size_t>(j)] == JointMotion::kRevolute;
    text += yaml::comment(fmt::format(
        "  true minus logged position of {}: {:.6g} {}", model.joints[static_cast<std::size_t>(j)].name,
        found.arm.offset[j] * (revolute ? kDegrees : 1.0), revolute ? "deg" : "m"));
  }
  return text;
}

std::string uncertainty_yaml(const Calibration& found) {
  std::string text =
      "# Joint distribution of the parameters that were calibrated: normal, with these means and this covariance.\n"
      "# If `logarithm` is true, the distribution is that of the value's natural logarithm.\n";
  if (found.commands == CommandKind::kPosition) text += "note: " + yaml::quoted(kNarrowIntervals) + '\n';
  text += "parameters:\n";
  const auto n = static_cast<Eigen::Index>(found.parameters.size());
  Eigen::VectorXd deviation(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const FittedParameter& p = found.parameters[static_cast<std::size_t>(i)];
    deviation[i] = p.prior.deviation;
    text += fmt::format("  - name: {}\n    unit: {}\n    logarithm: {}\n    mean: {}\n",
                        yaml::quoted(p.prior.name), yaml::quoted(p.prior.unit), p.prior.logarithmic,
                        p.prior.mean + p.prior.deviation * found.z[i]);
    text +=
        fmt::format("    value: {}\n    interval: [{}, {}]\n    told: {}\n", p.value, p.low, p.high, p.told);
    if (!p.told) text += fmt::format("    needs: {}  # {}\n", name(p.need), meaning(p.need));
    if (is_in_robot_file(p.prior.kind))
      text += fmt::format("    robot_file: {}\n", p.kept ? p.prior.nominal : p.value);
  }
  text += "covariance:\n";
  for (Eigen::Index i = 0; i < n; ++i) {
    std::vector<double> row;
    for (Eigen::Index k = 0; k <= i; ++k) row.push_back(deviation[i] * deviation[k] * found.covariance(i, k));
    text += fmt::format("  - [{}]\n", fmt::join(row, ", "));
  }
  return text;
}

}  // namespace armtune::internal
