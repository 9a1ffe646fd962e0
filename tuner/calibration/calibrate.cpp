#include "tuner/calibration/calibrate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "armtune/error.hpp"
#include "tuner/validation/motion_windows.hpp"

namespace armtune::internal {
namespace {

constexpr double kQuantile = 1.959964;  ///< of the normal distribution, for 95 % intervals
/// Lengths of windows in the phases of the fit [s]. In short windows even a wrong model stays near the log,
/// so that the fit converges from far away. Long windows tell parameters whose effect grows with time.
constexpr double kShortWindow = 0.25;
constexpr double kLongWindow = 0.5;
constexpr int kShortIterations = 8;  ///< of the first phase, which need not converge
/// Spread above which a parameter keeps the value of the robot file, because the log says next to nothing
/// about it.
constexpr double kUnseen = 0.9;
/// A judgement at shorter horizons would say nothing beyond the fit, whose windows have this length [s].
constexpr double kLeastHorizon = kLongWindow;
constexpr double kSameRate = 0.1;  ///< largest relative difference between the rates of two logs
/// Share of the fall direction that a joint's axis must have for gravity not to act about it.
constexpr double kVertical = 0.999;

struct NeedText {
  const char* name;
  const char* meaning;
};
constexpr std::array<NeedText, 7> kNeeds = {{
    {"none", "nothing more"},
    {"reversals", "the joint reverses often, at low speed"},
    {"steady_speeds", "the joint moves at several steady speeds, up to its limit"},
    {"accelerations", "the joint accelerates strongly, back and forth"},
    {"changing_commands", "the commands change fast, so that joints accelerate and reverse"},
    {"poses", "the arm passes many poses, with each link in several directions to gravity"},
    {"outside", "no motion of the arm tells it; measure it with an instrument outside the arm"},
}};

/// Throws if no held-out window is long enough to judge the result.
void check_held_out(std::span<const CommandedLog> logs) {
  double longest = 0.0;
  for (const auto& [log, commands] : logs) {
    for (const LogWindow& w : window_plan(log, known_commands(commands)).held_out)
      longest = std::max(longest, log.time[static_cast<std::size_t>(w.first + w.count - 1)] -
                                      log.time[static_cast<std::size_t>(w.first)]);
  }
  if (longest >= kStartTime + kLeastHorizon) return;
  const JointLog& log = logs.front().log;
  throw InputError(InputPlace{log.source, 0, "time"},
                   {"the log is too short to judge a calibration on a part that is not fitted; record a "
                    "longer one",
                    fmt::format("{:.4g} s", log.time.back() - log.time.front()), "20 s without gaps"});
}

void check_logs(const RobotModel& model, std::span<const CommandedLog> logs) {
  if (logs.empty())
    throw InputError(InputPlace{.key = "logs"}, {"there is no log to calibrate from", "0", "at least 1"});
  for (const auto& [log, commands] : logs) {
    check_joint_log(model, log);
    check_motion_commands(model, log, commands);
    const CommandKind first = logs.front().commands.kind;
    if (commands.kind == CommandKind::kReference)
      throw InputError(InputPlace{log.source, 0, "commands"},
                       {"the log holds references of a controller; give what the controller commanded",
                        name(commands.kind), "torque, velocity or position"});
    if (commands.kind != first)
      throw InputError(InputPlace{log.source, 0, "commands"},
                       {"the logs have different kinds of commands; calibrate each kind alone",
                        name(commands.kind), name(first)});
    const double period = median_step(commands.time);
    const double first_period = median_step(logs.front().commands.time);
    if (std::abs(period - first_period) > kSameRate * first_period)
      throw InputError(
          InputPlace{log.source, 0, "command time"},
          {"the logs have commands at different rates; calibrate each rate alone",
           fmt::format("{:.4g} Hz", 1.0 / period), fmt::format("{:.4g} Hz", 1.0 / first_period)});
  }
  check_held_out(logs);
}

/// True if gravity does not act about the first joint, so that no motion shows its zero position.
bool turns_about_gravity(const Chain& chain, int joint) {
  const Vec3 axis = chain.R_PB0[0].col(2);
  return joint == 0 && chain.motion[0] == JointMotion::kRevolute &&
         std::abs(axis.dot(chain.gravity.normalized())) > kVertical;
}

CalibrationNeed need_of(const Chain& chain, const CalibrationParameter& p) {
  switch (p.kind) {
    case ParameterKind::kCoulombFriction:
      return CalibrationNeed::kReversals;
    case ParameterKind::kViscousFriction:
      return CalibrationNeed::kSteadySpeeds;
    case ParameterKind::kRotorInertia:
    case ParameterKind::kVelocityGain:
      return CalibrationNeed::kAccelerations;
    case ParameterKind::kIntegralGain:
    case ParameterKind::kPositionGain:
    case ParameterKind::kTorqueFactor:
    case ParameterKind::kDelay:
      return CalibrationNeed::kChangingCommands;
    case ParameterKind::kEncoderOffset:
      return turns_about_gravity(chain, p.joint) ? CalibrationNeed::kOutside : CalibrationNeed::kPoses;
    default:
      return CalibrationNeed::kPoses;
  }
}

Eigen::VectorXd noise_of(std::span<const CommandedLog> logs) {
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(logs.front().log.q.cols());
  for (const CommandedLog& each : logs)
    variance += encoder_noise(each.log, sampling_period(each.log)).cwiseAbs2();
  return (variance / static_cast<double>(logs.size())).cwiseSqrt();
}

/// Returns the fitted windows of all logs, with the given length [s].
std::vector<ShotWindow> fitted_windows(std::span<const CommandedLog> logs,
                                       const std::vector<CommandSignal>& signals, const WindowModel& model,
                                       const Eigen::VectorXd& z, double length) {
  std::vector<ShotWindow> windows;
  WindowLengths lengths;
  lengths.fitted = length;
  for (std::size_t l = 0; l < logs.size(); ++l) {
    for (const LogWindow& w : window_plan(logs[l].log, known_commands(logs[l].commands), lengths).fitted)
      windows.push_back(model.window(logs[l].log, signals[l], w, z, false));
  }
  return windows;
}

FittedParameter fitted(const Chain& chain, const CalibrationParameter& p, double z, double deviation,
                       double told) {
  FittedParameter found;
  found.prior = p;
  found.value = p.value(z);
  found.low = p.value(z - kQuantile * deviation);
  found.high = p.value(z + kQuantile * deviation);
  found.spread = deviation;
  found.told = deviation <= told;
  found.kept = deviation > kUnseen;
  if (!found.told) found.need = need_of(chain, p);
  return found;
}

}  // namespace

const char* name(CalibrationNeed need) {
  return kNeeds[static_cast<std::size_t>(need)].name;
}

const char* meaning(CalibrationNeed need) {
  return kNeeds[static_cast<std::size_t>(need)].meaning;
}

Calibration calibrate(const RobotModel& model, std::span<const CommandedLog> logs,
                      const CalibrationOptions& options) {
  check_logs(model, logs);
  const MotionCommands& commands = logs.front().commands;
  const auto stopped = [&options] { return options.stop != nullptr && *options.stop; };
  Calibration found;
  found.commands = commands.kind;
  found.noise = noise_of(logs);
  const ShootingArm nominal = shooting_arm(model);
  WindowModel windows(model, nominal, commands, calibration_parameters(model, commands.kind, options.priors),
                      start_deviations(model, found.noise));
  const std::vector<CalibrationParameter>& parameters = windows.parameters();
  std::vector<CommandSignal> signals;
  for (const CommandedLog& each : logs) signals.emplace_back(each.commands);
  found.z = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(parameters.size()));
  for (const double length : {kShortWindow, kLongWindow}) {
    const bool last = length == kLongWindow;
    std::vector<ShotWindow> shots = fitted_windows(logs, signals, windows, found.z, length);
    ShootingFitOptions fit;
    if (!last) fit.most_iterations = kShortIterations;
    fit.with_covariance = last;
    fit.stop = options.stop;
    if (options.progress)
      fit.progress = [&](int i, double objective) {
        options.progress(last ? "long" : "short", i, objective);
      };
    found.fit = fit_windows(windows, shots, found.noise, found.z, fit);
    found.z = found.fit.z;
    found.interrupted = stopped();
    if (found.interrupted) return found;
  }
  found.covariance = found.fit.covariance;
  std::vector<CalibrationParameter> seen;
  std::vector<double> seen_z;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const double spread = std::sqrt(found.covariance(k, k));
    found.parameters.push_back(fitted(model.chain, parameters[i], found.z[k], spread, options.told));
    if (found.parameters.back().kept) continue;
    seen.push_back(parameters[i]);
    seen_z.push_back(found.z[k]);
  }
  const Eigen::VectorXd z = Eigen::VectorXd::Map(seen_z.data(), static_cast<Eigen::Index>(seen_z.size()));
  found.arm = arm_at(nominal, seen, z);
  found.before = horizon_error(model, nominal, logs, found.noise, HorizonPart::kHeldOut);
  found.after = horizon_error(model, found.arm, logs, found.noise, HorizonPart::kHeldOut);
  return found;
}

}  // namespace armtune::internal
