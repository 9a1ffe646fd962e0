#include "core/control/laws/joint_trajectory_law.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/control/laws/arm_torque_law.hpp"
#include "core/control/laws/first_gains.hpp"

namespace armtune::internal {
namespace {

constexpr double kIntegralRate = 1.0;  // 1/s, of P: an arm's weight is borne after some seconds
constexpr double kNoClamp = 1e6;       // N m, N: beyond any joint
constexpr double kOuterRate = 0.15;    // of a drive's, for the positions around it

constexpr std::array kEffortGains = {"jtc_p",
                                     "jtc_i",
                                     "jtc_d",
                                     "jtc_i_clamp",
                                     "jtc_ff_velocity_scale",
                                     "jtc_antiwindup",
                                     "jtc_tracking_time",
                                     "jtc_error_deadband",
                                     "jtc_u_clamp_max",
                                     "jtc_u_clamp_min",
                                     "jtc_i_clamp_min",
                                     "jtc_angle_wraparound",
                                     "jtc_distro"};
constexpr std::array kVelocityGains = {"jtc_velocity_p",
                                       "jtc_velocity_i",
                                       "jtc_velocity_d",
                                       "jtc_velocity_i_clamp",
                                       "jtc_velocity_ff_velocity_scale",
                                       "jtc_velocity_antiwindup",
                                       "jtc_velocity_tracking_time",
                                       "jtc_velocity_error_deadband",
                                       "jtc_velocity_u_clamp_max",
                                       "jtc_velocity_u_clamp_min",
                                       "jtc_velocity_i_clamp_min",
                                       "jtc_velocity_angle_wraparound",
                                       "jtc_velocity_distro"};
static_assert(kEffortGains.size() == kVelocityGains.size());

/// The kinds of anti-windup, in the order of the numbers in a gains file.
constexpr std::array kAntiWindups = {AntiWindup::kOfContribution, AntiWindup::kOfIntegral, AntiWindup::kNone,
                                     AntiWindup::kConditional, AntiWindup::kBackCalculation};

/// True if the position error of a joint is wrapped to -pi .. pi. asked: the joint's angle_wraparound.
bool wraps(Wraparound rule, bool has_limits, bool asked) {
  if (rule == Wraparound::kAsParameter) return asked;
  return rule == Wraparound::kAll || !has_limits;
}

/// Its own gains: units of an effort, or of a velocity that is commanded.
std::vector<GainField> jtc_fields(const char* kind, const std::array<const char*, 5>& units, double p,
                                  double d) {
  constexpr auto kJoints = GainShape::kJoints;
  const bool effort = std::string_view(kind) == kJointTrajectoryController;
  const char* const* names = effort ? kEffortGains.data() : kVelocityGains.data();
  GainField anti_windup = not_tuned(own_gain(
      GainShape::kScalar, names[5], "",
      "anti-windup: with 1 (ROS: legacy) the integral itself stops at i_clamp; with 0 it keeps growing, and "
      "only its contribution to the command is clamped; 2: none, 3: conditional_integration, 4: "
      "back_calculation, as ROS 2 Jazzy has them",
      1.0));
  anti_windup.below = kAntiWindups.size();
  GainField wraparound = not_tuned(
      own_gain(kJoints, names[11], "",
               "angle_wraparound of ROS 2 Humble: with 1 the position error is wrapped to -pi .. pi", 0.0));
  wraparound.below = 2.0;
  GainField distro = not_tuned(own_gain(
      GainShape::kScalar, names[12], "",
      "the distribution of ROS that is simulated; 0: ROS 2 Jazzy, 1: ROS 2 Humble, 2: ROS 1 Noetic", 0.0));
  distro.below = kRosRules.size();
  return {
      own_gain(kJoints, names[0], units[0], "p on the position error of each joint", p),
      own_gain(kJoints, names[1], units[1], "i on the integral of each joint's position error", 0.0),
      own_gain(kJoints, names[2], units[2], "d on the velocity error of each joint", d),
      not_tuned(own_gain(kJoints, names[3], units[3],
                         "i_clamp: largest contribution of the integral to the command; the default is too "
                         "large to have an effect",
                         kNoClamp)),
      not_tuned(own_gain(kJoints, names[4], units[4],
                         effort ? "ff_velocity_scale: feed-forward torque per desired joint velocity"
                                : "ff_velocity_scale: share of the desired velocity that is added to the "
                                  "command",
                         effort ? 0.0 : 1.0)),
      anti_windup,
      not_tuned(own_gain(kJoints, names[6], "s",
                         "tracking_time_constant of back_calculation; 0: sqrt(d / i), or p / i without d",
                         0.0)),
      not_tuned(own_gain(kJoints, names[7], "rad",
                         "error_deadband: position errors up to this leave the integral unchanged", 0.0)),
      not_tuned(
          own_gain(kJoints, names[8], units[3],
                   "u_clamp_max: largest command, without the feed-forward; the default is too large to "
                   "have an effect",
                   kNoClamp)),
      not_tuned(own_gain(kJoints, names[9], units[3],
                         "absolute value of u_clamp_min, the negative lower bound of the command "
                         "without the feed-forward",
                         kNoClamp)),
      not_tuned(own_gain(kJoints, names[10], units[3],
                         "absolute value of i_clamp_min, the negative lower bound of the integral's "
                         "contribution; 0: the same as i_clamp",
                         0.0)),
      wraparound,
      distro};
}

}  // namespace

bool is_joint_trajectory_controller(const std::string& kind) {
  return kind == kJointTrajectoryController || kind == kJointTrajectoryVelocityController;
}

std::string jtc_name(const std::string& kind, const std::string& what) {
  return (kind == kJointTrajectoryVelocityController ? "jtc_velocity_" : "jtc_") + what;
}

const JointVector& jtc_gain(const Gains& gains, const std::string& what) {
  return own(gains, jtc_name(gains.controller, what));
}
JointVector& jtc_gain(Gains& gains, const std::string& what) {
  return own(gains, jtc_name(gains.controller, what));
}

RosDistro jtc_distro(const Gains& gains) {
  return static_cast<RosDistro>(static_cast<int>(jtc_gain(gains, "distro")[0]));
}

double jtc_lower_i_clamp(const Gains& gains, Eigen::Index joint) {
  const double own_size = jtc_gain(gains, "i_clamp_min")[joint];
  return own_size != 0.0 ? own_size : jtc_gain(gains, "i_clamp")[joint];
}

void fit_integral_to_clamp(const RobotModel& model, Gains& gains) {
  if (gains.controller != kJointTrajectoryController) return;
  const JointVector effort = model.effort_limits();
  for (Eigen::Index i = 0; i < effort.size(); ++i) {
    const double clamp = std::min(jtc_gain(gains, "i_clamp")[i], jtc_lower_i_clamp(gains, i));
    if (clamp < effort[i]) jtc_gain(gains, "i")[i] *= clamp / effort[i];
  }
}

bool feeds_next_velocity(const Gains& gains) {
  return is_joint_trajectory_controller(gains.controller) &&
         rules_of(jtc_distro(gains)).feeds_next_velocity && !jtc_gain(gains, "ff_velocity_scale").isZero(0.0);
}

JtcNumbers jtc_numbers(const RobotModel& model, const Gains& gains) {
  JtcNumbers numbers;
  numbers.held_by_robot = model.compensates_gravity && gains.controller == kJointTrajectoryController;
  const auto anti_windup = static_cast<std::size_t>(jtc_gain(gains, "antiwindup")[0]);
  for (int i = 0; i < model.n(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    RosPidGains& pid = numbers.pid[k];
    pid.p = jtc_gain(gains, "p")[i];
    pid.i = jtc_gain(gains, "i")[i];
    pid.d = jtc_gain(gains, "d")[i];
    pid.i_max = jtc_gain(gains, "i_clamp")[i];
    pid.i_min = -jtc_lower_i_clamp(gains, i);
    pid.u_max = jtc_gain(gains, "u_clamp_max")[i];
    pid.u_min = -jtc_gain(gains, "u_clamp_min")[i];
    pid.anti_windup = kAntiWindups[anti_windup];
    pid.tracking_time = jtc_gain(gains, "tracking_time")[i];
    pid.deadband = jtc_gain(gains, "error_deadband")[i];
    numbers.feed_forward[k] = jtc_gain(gains, "ff_velocity_scale")[i];
    numbers.wraps[k] = wraps(rules_of(jtc_distro(gains)).wraparound, model.joints[k].limits.has_position,
                             jtc_gain(gains, "angle_wraparound")[i] != 0.0);
  }
  return numbers;
}

ControllerKind joint_trajectory_controller() {
  return {
      kJointTrajectoryController,
      "ROS's joint_trajectory_controller with effort commands: a PID for each joint along a joint trajectory",
      {},
      jtc_fields(kJointTrajectoryController, {"N m/rad", "N m/(rad s)", "N m s/rad", "N m", "N m s/rad"},
                 100.0, 10.0),
      [](const LawSetup& setup) { return make_torque_law(ArmLawKind::kJointTrajectory, setup); },
      [](const RobotModel& robot, const JointVector& q, Gains& gains) {
        critically_damped(robot, q, own(gains, "jtc_p"), own(gains, "jtc_d"));
        own(gains, "jtc_i") = kIntegralRate * own(gains, "jtc_p");
        without_velocity_limits(gains);
      },
      false,
      ArmLawKind::kJointTrajectory};
}

ControllerKind joint_trajectory_velocity_controller() {
  return {kJointTrajectoryVelocityController,
          "ROS's joint_trajectory_controller with velocity commands: a PID for each joint commands its "
          "simulated velocity drive",
          {},
          jtc_fields(kJointTrajectoryVelocityController, {"1/s", "1/s^2", "1", "rad/s", "1"},
                     kOuterRate * kDriveRate, 0.0),
          [](const LawSetup& setup) { return make_torque_law(ArmLawKind::kJointTrajectoryVelocity, setup); },
          [](const RobotModel&, const JointVector&, Gains& gains) { without_velocity_limits(gains); },
          false,
          ArmLawKind::kJointTrajectoryVelocity};
}

}  // namespace armtune::internal
