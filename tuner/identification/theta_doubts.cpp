#include "tuner/identification/theta_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tuner/identification/effort_words.hpp"

namespace armtune::internal {
namespace {

constexpr double kLeastTorque = 0.005;  ///< share of the effort limit
constexpr double kTooMuchUnexplained = 0.5;
constexpr double kWorseThanFile = 1.2;
constexpr double kNoticeable = 0.15;  ///< share of a torque that theta may leave unexplained in any case
constexpr double kHeavier = 3.0;
constexpr double kShareOfArm = 0.5;
constexpr double kOtherArmScale = 1.8;
constexpr double kDead =
    0.05;  ///< share of the torque that the robot file needs; an arm may need a third of an estimated rotor's
constexpr double kFileFails = 0.5;   ///< check_arm: least share of every torque unexplained by the robot file
constexpr double kThetaFails = 0.1;  ///< check_arm: least share of some torque unexplained by theta
constexpr double kVanished = 0.1;    ///< check_arm: share of a link's mass in the robot file
constexpr double kGrownRotor =
    6.0;  ///< check_arm: times the rotor inertia in the robot file, which may be an estimate
constexpr double kLighter = 0.6;   ///< check_scale: share of the torque that the robot file predicts
constexpr double kFollows = 0.8;   ///< check_scale: least correlation of a torque with the predicted one
constexpr double kOpposite = 0.7;  ///< check_scale: least correlation with the opposite of the prediction
constexpr double kSigned = 0.002;  ///< check_scale: least predicted torque whose sign counts, as a share
constexpr double kLoaded = 0.1;    ///< check_scale: least predicted torque as a share of the effort limit

std::string check_joint(const RobotModel& model, int joint, const Unexplained& rows, double noise,
                        const char* which) {
  const JointInfo& info = model.joints[static_cast<std::size_t>(joint)];
  const double torque = std::max(rows.torque[joint], kLeastTorque * info.limits.effort);
  const double left = std::sqrt(std::max(0.0, std::pow(rows.by_theta[joint], 2) - noise * noise));
  const bool too_much = left > kTooMuchUnexplained * torque;
  const bool worse = left > kNoticeable * torque && left > kWorseThanFile * rows.by_file[joint];
  if (!too_much && !worse) return {};
  const EffortWords effort = effort_words(model, joint);
  return fmt::format(
      "the identified parameters leave {:.3g} {} of the {} of {} unexplained {}. The whole {} there is "
      "{:.3g}, and the parameters of the robot file leave {:.3g} of it unexplained (all are RMS values). "
      "Check unit, sign, column and zero position of this joint and of the joints after it",
      left, effort.unit, effort.name, info.name, which, effort.name, rows.torque[joint], rows.by_file[joint]);
}

/// Returns a doubt if the torque is nearly zero. check_joint does not find this, because parameters can be
/// fitted to such a torque as they can to noise.
std::string check_channel(const RobotModel& model, int joint, const Unexplained& rows) {
  const JointInfo& info = model.joints[static_cast<std::size_t>(joint)];
  const double needed = rows.by_file[joint];  // the robot file's torque if the logged torque is zero
  if (needed < kLeastTorque * info.limits.effort || rows.torque[joint] > kDead * needed) return {};
  const EffortWords effort = effort_words(model, joint);
  return fmt::format(
      "the {} of {} is only {:.3g} {}, but by the parameters of the robot file it would be about {:.3g} (RMS "
      "values); "
      "check its column, which may be dead, of another joint, or in another unit",
      effort.name, info.name, rows.torque[joint], effort.unit, needed);
}

/// The joint whose torque theta explains worst (-1: none), and the unexplained share of that torque.
struct Worst {
  int joint = -1;
  double share = 0.0;
};

Worst worst_by_theta(const RobotModel& model, const Unexplained& rows, const Identification& found) {
  Worst worst;
  for (int j = 0; rows.rows > 0 && j < model.n(); ++j) {
    if (rows.torque[j] < kLeastTorque * model.joints[static_cast<std::size_t>(j)].limits.effort) continue;
    const double left =
        std::sqrt(std::max(0.0, std::pow(rows.by_theta[j], 2) - std::pow(found.torque_noise[j], 2)));
    if (left > worst.share * rows.torque[j]) worst = {j, left / rows.torque[j]};
  }
  return worst;
}

int mass_index(int /*n*/, int link) {
  return link * kLinkParameters;
}

/// The first of a joint's parameters.
int rotor_index(int n, int joint) {
  return joint_parameter_index(n, joint);
}

/// Returns the joint or link whose entry of theta has the largest ratio to the robot file's, or the smallest
/// if smallest is true. index(n, i): place of this entry in theta. Entries that are zero in the file do not
/// count; -1: none counts.
int extreme_ratio(const RobotModel& model, const Identification& found, int (*index)(int, int), bool smallest,
                  double& ratio) {
  const ParameterVector file = theta_of(model.chain);
  int at = -1;
  for (int i = 0; i < model.n(); ++i) {
    const int k = index(model.n(), i);
    if (!(file[k] > 0.0)) continue;
    const double own = found.theta[k] / file[k];
    if (at >= 0 && (smallest ? own >= ratio : own <= ratio)) continue;
    ratio = own;
    at = i;
  }
  return at;
}

/// Returns a doubt if the log may be of another arm: the robot file explains no torque, and theta does not
/// explain all either, because the geometry of another arm causes torques that no masses explain, or it
/// explains them by links that weigh next to nothing or by rotors that are far too heavy.
std::string check_arm(const RobotModel& model, const Identification& found) {
  double least = 1.0;
  bool any = false;
  for (int j = 0; j < model.n(); ++j) {
    const Unexplained& rows = found.fitted;
    if (rows.torque[j] < kLeastTorque * model.joints[static_cast<std::size_t>(j)].limits.effort) continue;
    least = std::min(least, rows.by_file[j] / rows.torque[j]);
    any = true;
  }
  if (!any || least < kFileFails) return {};
  const std::string fails =
      fmt::format("the parameters of the robot file leave {:.0f} % or more of every joint's {} unexplained",
                  100.0 * least, effort_word_of_all(model, &EffortWords::name));
  constexpr const char* kAdvice =
      "; the log may be of another arm: check --robot. A robot file without real masses has the same "
      "effect if friction is not as armtune models it";
  const Worst fitted = worst_by_theta(model, found.fitted, found);
  const Worst held = worst_by_theta(model, found.held_out, found);
  const Worst& worst = held.share > fitted.share ? held : fitted;
  if (worst.joint >= 0 && worst.share >= kThetaFails)
    return fmt::format("{}, and the identified ones still leave {:.0f} % of {}{}{}", fails,
                       100.0 * worst.share, model.joints[static_cast<std::size_t>(worst.joint)].name,
                       &worst == &held ? " on the rows held out of the fit" : "", kAdvice);
  double ratio = 1.0;
  if (const int link = extreme_ratio(model, found, mass_index, true, ratio); link >= 0 && ratio < kVanished)
    return fmt::format("{}, and with the identified ones {} weighs only {:.2g} times what the file gives{}",
                       fails, model.joints[static_cast<std::size_t>(link)].link, ratio, kAdvice);
  const int joint = extreme_ratio(model, found, rotor_index, false, ratio);
  if (joint < 0 || ratio < kGrownRotor) return {};
  return fmt::format("{}, and the identified rotor inertia of {} is {:.2g} times that of the file{}", fails,
                     model.joints[static_cast<std::size_t>(joint)].name, ratio, kAdvice);
}

/// Returns a doubt if the torque of a joint is the opposite of what the robot file predicts. Returns a doubt
/// too if the torque of a joint that bears much of its limit follows what the robot file predicts, but is
/// much smaller: the arm is much lighter than the file's. A larger torque is no doubt, as a payload causes
/// it.
std::string check_scale(const RobotModel& model, const Unexplained& rows) {
  for (int j = 0; rows.rows > 0 && j < model.n(); ++j) {
    const JointInfo& info = model.joints[static_cast<std::size_t>(j)];
    const double torque = rows.torque[j];
    const double file = rows.file[j];
    // From the squared RMS of the difference of both series.
    const double product = 0.5 * (torque * torque + file * file - std::pow(rows.by_file[j], 2));
    const EffortWords effort = effort_words(model, j);
    if (file >= kSigned * info.limits.effort && product < -kOpposite * torque * file)
      return fmt::format(
          "the {0} of {1} has the opposite sign of what the parameters of the robot file predict; check the sign "
          "of its {0} and of its position",
          effort.name, info.name);
    const double scale = product / (file * file);
    if (file < kLoaded * info.limits.effort || product < kFollows * torque * file || scale > kLighter)
      continue;
    return fmt::format(
        "the {0} of {1} is only {2:.2g} times what the parameters of the robot file predict. The log may be of "
        "another, lighter arm: check --robot, the masses in the robot file and the unit of the {0}. A spring "
        "or a counterweight that bears part of the arm has the same effect, and armtune does not model it",
        effort.name, info.name, scale);
  }
  return {};
}

}  // namespace

std::vector<std::string> theta_doubts(const RobotModel& model, const Identification& found) {
  std::vector<std::string> doubts;
  for (int j = 0; j < model.n(); ++j) {
    std::string doubt = check_joint(model, j, found.fitted, found.torque_noise[j], "on the rows of the fit");
    if (doubt.empty() && found.held_out.rows > 0)
      doubt = check_joint(model, j, found.held_out, found.torque_noise[j], "on the rows held out of the fit");
    if (doubt.empty()) doubt = check_channel(model, j, found.fitted);
    if (!doubt.empty()) doubts.push_back(doubt);
  }
  if (std::string doubt = check_arm(model, found); !doubt.empty()) doubts.push_back(std::move(doubt));
  if (std::string doubt = check_scale(model, found.fitted); !doubt.empty())
    doubts.push_back(std::move(doubt));
  const ParameterVector file = theta_of(model.chain);
  double arm = 0.0;
  double file_arm = 0.0;
  for (int i = 0; i < model.n(); ++i) {
    arm += found.theta[i * kLinkParameters];
    file_arm += file[i * kLinkParameters];
  }
  for (int i = 0; i < model.n(); ++i) {
    const double mass = found.theta[i * kLinkParameters];
    const double file_mass = file[i * kLinkParameters];
    if (mass < kHeavier * file_mass || mass - file_mass < kShareOfArm * file_arm) continue;
    doubts.push_back(
        fmt::format("{} would weigh {:.3g} kg, but the robot file gives {:.3g} kg; check the units of each "
                    "{}, the zero positions, and whether the robot file includes the tool",
                    model.joints[static_cast<std::size_t>(i)].link, mass, file_mass,
                    effort_word_of_all(model, &EffortWords::name)));
  }
  if (arm > kOtherArmScale * file_arm || kOtherArmScale * arm < file_arm) {
    doubts.push_back(
        fmt::format("the moved links would weigh {:.3g} kg, but the robot file gives {:.3g} kg; check the "
                    "units of each {} and --robot",
                    arm, file_arm, effort_word_of_all(model, &EffortWords::name)));
  }
  return doubts;
}

}  // namespace armtune::internal
