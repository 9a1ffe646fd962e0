#include "tuner/validation/log_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tuner/validation/channel_checks.hpp"
#include "tuner/validation/torque_slopes.hpp"
#include "tuner/validation/torque_timing.hpp"

namespace armtune::internal {
namespace {

/// A filter is named instead of a delay if it leaves this share of the delay's residual.
constexpr double kFilterOverDelay = 0.9;
/// Share of a residual that its causes may leave if they are to explain it.
constexpr double kLittleLeft = 0.2;
/// Most rows that signs and order are searched with.
constexpr Eigen::Index kMostInstants = 2000;

void add_timing(const TorqueRows& rows, const ValidationThresholds& thresholds,
                std::vector<LogFinding>& out) {
  const TorqueTiming timing = torque_timing(rows);
  const bool filtered = timing.filter_gain < kFilterOverDelay * timing.delay_gain;
  if (filtered) {
    // The filters of this comparison, of 20 Hz, smooth reversals of friction like a time constant of some 10
    // ms.
    if (timing.filter_gain < thresholds.offset_gain && timing.time_constant > thresholds.filter_time)
      out.push_back({.kind = LogFindingKind::kTorqueFiltered, .value = timing.time_constant});
  } else if (timing.delay_gain < thresholds.offset_gain && std::abs(timing.delay) > thresholds.time_offset) {
    out.push_back({.kind = LogFindingKind::kTorqueOffset, .value = timing.delay});
  }
}

/// Compares signs, order, zero positions and mounting as identification does.
std::optional<LogMistake> mistake_in(const RobotModel& model, const JointLog& log, const LoggedMotion& motion,
                                     const TorqueRows& rows) {
  LogInstants noise;
  noise.begin_log(motion.torque_norm);
  for (Eigen::Index i = 0; i < log.samples(); ++i) noise.add_logged_torque(log.torque.row(i).transpose());
  std::vector<LogInstant> instants;
  const Eigen::Index step = (rows.count() + kMostInstants - 1) / kMostInstants;
  for (Eigen::Index i = 0; i < rows.count(); i += std::max<Eigen::Index>(1, step)) {
    LogInstant at;
    at.q = rows.q[static_cast<std::size_t>(i)];
    for (JointVector* x : {&at.qd, &at.qdd, &at.torque}) x->resize(model.n());
    for (int j = 0; j < model.n(); ++j) {
      const Eigen::MatrixXd& own = rows.joint[static_cast<std::size_t>(j)];
      at.qd[j] = own(i, kJointVelocity);
      at.qdd[j] = own(i, kJointAcceleration);
      at.torque[j] = own(i, kMeasuredTorque);
    }
    instants.push_back(std::move(at));
  }
  return compare_with_robot_file(model, instants, noise.torque_noise()).mistake;
}

/// Returns true if a finding makes every torque wrong. Signs, mounting and times cannot be judged then.
bool spoils_torques(const LogFinding& finding, double duration, const ValidationThresholds& thresholds) {
  switch (finding.kind) {
    case LogFindingKind::kPositionUnit:
    case LogFindingKind::kRate:
      return true;
    case LogFindingKind::kTorqueFrozen:
    case LogFindingKind::kPositionFrozen:
      return finding.value > thresholds.frozen_share * duration;
    default:
      return false;
  }
}

/// Returns the fitted direction of gravity if it explains more than any other cause, and all causes together
/// leave little of the residuals. Nothing otherwise.
std::optional<LogFinding> tilt_of(const Misfit& misfit, const std::vector<bool>& matches) {
  if (misfit.causes.empty() || misfit.causes.front().kind != CauseKind::kGravityDirection)
    return std::nullopt;
  for (std::size_t j = 0; j < matches.size(); ++j) {
    if (!matches[j] && misfit.left[static_cast<Eigen::Index>(j)] > kLittleLeft) return std::nullopt;
  }
  const MisfitCause& cause = misfit.causes.front();
  return LogFinding{.kind = LogFindingKind::kTilt, .value = cause.value, .direction = cause.vector};
}

std::string joint_name(const RobotModel& model, int joint) {
  return joint < 0 ? "the log" : model.joints[static_cast<std::size_t>(joint)].name;
}

std::string frozen_text(const char* channel, const LogFinding& finding, const std::string& name) {
  return fmt::format(
      "the {} of {} keeps one value for {:.2g} s from {:.2f} s on, although the joint moves; leave this "
      "part out, or check the recorder",
      channel, name, finding.value, finding.time);
}

std::string velocity_text(const LogFinding& finding, const RobotModel& model) {
  const std::string name = joint_name(model, finding.joint);
  switch (finding.kind) {
    case LogFindingKind::kRate:
      return fmt::format(
          "the positions change {:.3g} times as fast as the measured velocities say; divide the time stamps' steps "
          "by {:.3g}, or check the sampling rate",
          finding.value, finding.value);
    case LogFindingKind::kVelocityScale:
      return fmt::format(
          "the measured velocity of {} is {:.3g} times the derivative of its position; check the units", name,
          finding.value);
    case LogFindingKind::kVelocitySign:
      return fmt::format("the measured velocity of {} has the other sign than its position; correct its sign",
                         name);
    case LogFindingKind::kVelocityOrder:
      return fmt::format(
          "the measured velocity of {} is the derivative of the position of {}; check the order of the "
          "columns",
          name, joint_name(model, finding.other));
    case LogFindingKind::kVelocityOther:
      return fmt::format(
          "the measured velocity of {} is not the derivative of a position (correlation {:.2f}); check "
          "its column, or leave the velocities out",
          name, finding.value);
    default:
      return fmt::format(
          "the measured velocities are {:.3g} s late against the positions; shift them, or leave them "
          "out",
          finding.value);
  }
}

}  // namespace

const char* name(LogFindingKind kind) {
  constexpr std::array kNames = {"rate",
                                 "velocity_scale",
                                 "velocity_sign",
                                 "velocity_order",
                                 "velocity_other",
                                 "velocity_offset",
                                 "torque_offset",
                                 "torque_filtered",
                                 "torque_clipped",
                                 "torque_frozen",
                                 "velocity_frozen",
                                 "position_frozen",
                                 "jump",
                                 "position_unit",
                                 "tilt",
                                 "mistake",
                                 ""};
  return kNames[static_cast<std::size_t>(kind)];
}

const char* kind_of(const LogFinding& finding) {
  return finding.mistake ? name(finding.mistake->kind) : name(finding.kind);
}

std::vector<LogFinding> motion_findings(const RobotModel& model, const JointLog& log,
                                        const LoggedMotion& motion, const ValidationThresholds& thresholds) {
  std::vector<LogFinding> out = channel_findings(model, log, motion, thresholds);
  if (log.has_velocities()) {
    const std::vector<LogFinding> more = velocity_findings(motion, thresholds);
    out.insert(out.end(), more.begin(), more.end());
  }
  return out;
}

std::vector<LogFinding> log_findings(const RobotModel& model, const JointLog& log, const LoggedMotion& motion,
                                     const TorqueRows& rows, const Misfit& misfit,
                                     const ValidationThresholds& thresholds) {
  std::vector<LogFinding> out = motion_findings(model, log, motion, thresholds);
  const double duration = log.time.back() - log.time.front();
  const bool spoiled = std::any_of(out.begin(), out.end(), [&](const LogFinding& finding) {
    return spoils_torques(finding, duration, thresholds);
  });
  if (spoiled) return out;
  const std::vector<bool> matches = matching_joints(model, torque_residuals(rows, thresholds), thresholds);
  const auto tilt = tilt_of(misfit, matches);
  auto mistake = mistake_in(model, log, motion, rows);
  if (!mistake && !tilt && suggests_another_arm(model, rows, misfit, matches, thresholds)) mistake.emplace();
  if (mistake && (!tilt || mistake->kind == MistakeKind::kMounting)) {
    out.push_back(
        {.joint = mistake->joint, .other = mistake->other, .value = mistake->value, .mistake = mistake});
    return out;
  }
  if (tilt) out.push_back(*tilt);
  add_timing(rows, thresholds, out);
  return out;
}

std::string to_text(const LogFinding& finding, const RobotModel& model) {
  const std::string name = joint_name(model, finding.joint);
  switch (finding.kind) {
    case LogFindingKind::kTorqueOffset:
      return fmt::format("the torques are {:.3g} s late against the positions; shift their time stamps",
                         finding.value);
    case LogFindingKind::kTorqueFiltered:
      return fmt::format(
          "the torques seem to have passed a low-pass filter with a time constant of {:.2g} s; log "
          "unfiltered torques",
          finding.value);
    case LogFindingKind::kTorqueClipped:
      return fmt::format(
          "{:.2g} % of the torques of {} stay at {:.4g}, where they seem to be clipped; log a motion "
          "that needs less torque, or raise the recorder's range",
          100.0 * finding.share, name, finding.value);
    case LogFindingKind::kTorqueFrozen:
      return frozen_text("torque", finding, name);
    case LogFindingKind::kVelocityFrozen:
      return frozen_text("measured velocity", finding, name);
    case LogFindingKind::kPositionFrozen:
      return frozen_text("position", finding, name);
    case LogFindingKind::kJump:
      return fmt::format(
          "the position of {} jumps by {:.3g} at {:.3f} s; the recording seems to have been interrupted",
          name, finding.value, finding.time);
    case LogFindingKind::kPositionUnit:
      return fmt::format(
          "the position of {} is {:.3g} times its largest limit; if it is in degrees, convert it to "
          "radians",
          name, finding.value);
    case LogFindingKind::kTilt:
      return fmt::format(
          "gravity seems to point {:.0f} degrees away from the robot file's direction; check the "
          "mounting",
          finding.value * 180.0 / M_PI);
    case LogFindingKind::kMistake:
      return finding.mistake ? to_text(*finding.mistake, model) : std::string();
    default:
      return velocity_text(finding, model);
  }
}

}  // namespace armtune::internal
