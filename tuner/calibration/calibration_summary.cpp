#include "tuner/calibration/calibration_summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tuner/calibration/calibration_files.hpp"

namespace armtune::internal {
namespace {

/// A result that fewer windows judge depends much on their motion.
constexpr long kFewWindows = 5;

/// Parts of the name of a parameter, such as elbow_joint/viscous_friction.
std::string what_of(const CalibrationParameter& p) {
  return p.joint < 0 ? p.name : p.name.substr(p.name.rfind('/') + 1);
}
std::string joint_of(const CalibrationParameter& p) {
  return p.name.substr(0, p.name.rfind('/'));
}

/// Returns "a", "a and b" or "a, b and c".
std::string enumeration(const std::vector<std::string>& words) {
  if (words.size() < 2) return words.empty() ? "" : words.front();
  return fmt::format("{} and {}", fmt::join(words.begin(), words.end() - 1, ", "), words.back());
}

/// Returns, for example, "rotor_inertia of 3 joints".
std::string shortly(const UntoldKind& kind) {
  if (kind.joints.empty()) return kind.what;
  if (kind.every_joint) return kind.what + " of every joint";
  if (kind.joints.size() == 1) return kind.what + " of " + kind.joints.front();
  return fmt::format("{} of {} joints", kind.what, kind.joints.size());
}

std::string fully(const UntoldKind& kind) {
  return kind.joints.empty() ? kind.what : kind.what + " of " + enumeration(kind.joints);
}

std::string gain_clause(const HeldOutGain& gain) {
  const std::string windows = gain.windows == 1 ? "1 window" : fmt::format("{} windows", gain.windows);
  if (gain.better())
    return fmt::format(
        "On the held-out part of the log, the error of the simulated motion after {} s fell "
        "by {:.1f} % ({})",
        gain.horizon, 100.0 * (1.0 - gain.ratio), windows);
  return fmt::format(
      "The calibrated arm is not better on the held-out part of the log: after {} s its error "
      "is {:.1f} % of that of the robot file ({})",
      gain.horizon, 100.0 * gain.ratio, windows);
}

bool has_fitted(const Calibration& found, std::initializer_list<ParameterKind> kinds) {
  return std::any_of(found.parameters.begin(), found.parameters.end(), [&](const FittedParameter& p) {
    return !p.kept && std::find(kinds.begin(), kinds.end(), p.prior.kind) != kinds.end();
  });
}

}  // namespace

HeldOutGain held_out_gain(const Calibration& found) {
  HeldOutGain gain;
  for (std::size_t h = 0; h < kReportedHorizons.size(); ++h) {
    if (found.before.windows[h] > 0) gain.at = h;
  }
  gain.horizon = kReportedHorizons[gain.at];
  gain.windows = found.before.windows[gain.at];
  const auto row = static_cast<Eigen::Index>(gain.at);
  const Eigen::ArrayXd noise = found.noise.array().square();
  const Eigen::ArrayXd before = found.before.rms.row(row).transpose().array().square() + noise;
  const Eigen::ArrayXd after = found.after.rms.row(row).transpose().array().square() + noise;
  gain.ratio = std::sqrt((after / before).mean());
  return gain;
}

std::vector<UntoldKind> untold_kinds(const Calibration& found, std::optional<CalibrationNeed> need) {
  std::vector<UntoldKind> kinds;
  for (const FittedParameter& p : found.parameters) {
    if (p.told || (need && p.need != *need)) continue;
    const std::string what = what_of(p.prior);
    if (kinds.empty() || kinds.back().what != what) {
      const bool told_somewhere = std::any_of(
          found.parameters.begin(), found.parameters.end(),
          [&](const FittedParameter& other) { return other.prior.kind == p.prior.kind && other.told; });
      kinds.push_back({what, {}, !told_somewhere});
    }
    if (p.prior.joint >= 0) kinds.back().joints.push_back(joint_of(p.prior));
  }
  return kinds;
}

std::string headline(const Calibration& found) {
  std::vector<std::string> untold;
  for (const UntoldKind& kind : untold_kinds(found)) untold.push_back(shortly(kind));
  return gain_clause(held_out_gain(found)) + (untold.empty()
                                                  ? "; the log tells every parameter"
                                                  : "; the log does not tell " + enumeration(untold));
}

std::vector<std::string> untold_sentences(const Calibration& found) {
  std::vector<std::string> sentences;
  for (int i = 0; i <= static_cast<int>(CalibrationNeed::kOutside); ++i) {
    const auto need = static_cast<CalibrationNeed>(i);
    std::vector<std::string> names;
    for (const UntoldKind& kind : untold_kinds(found, need)) names.push_back(fully(kind));
    if (names.empty()) continue;
    const char* record = need == CalibrationNeed::kOutside ? "" : "record a motion in which ";
    sentences.push_back(fmt::format("{}: {}{}", enumeration(names), record, meaning(need)));
  }
  return sentences;
}

std::vector<std::string> caution_sentences(const Calibration& found) {
  std::vector<std::string> sentences;
  const HeldOutGain gain = held_out_gain(found);
  if (!gain.better())
    sentences.emplace_back(
        "values and intervals are not reliable, because the calibrated arm is not better: the robot file was "
        "right already, or what is wrong is not fitted; armtune validate shows causes");
  if (found.commands == CommandKind::kPosition) sentences.emplace_back(kNarrowIntervals);
  if (found.commands != CommandKind::kTorque)
    sentences.emplace_back(
        "the torque of the drives is not in the log, so friction, rotor inertia and gains of drives are only "
        "known relative to the inertia and the weight of the links in the robot file");
  if (!found.fit.converged)
    sentences.push_back(
        fmt::format("the fit stopped after {} iterations without converging, so its intervals are not "
                    "reliable",
                    found.fit.iterations));
  if (has_fitted(found, {ParameterKind::kDelay, ParameterKind::kTiltX, ParameterKind::kTiltY,
                         ParameterKind::kEncoderOffset, ParameterKind::kTorqueFactor}))
    sentences.emplace_back(
        "delay, tilt of the base and encoder offsets count in the held-out error, but a robot file cannot "
        "contain them; comments in robot.yaml give them");
  if (gain.windows < kFewWindows)
    sentences.push_back(
        fmt::format("the held-out part has only {} of the windows that reach {} s; a longer "
                    "log judges the result better",
                    gain.windows, gain.horizon));
  return sentences;
}

}  // namespace armtune::internal
