#include "core/control/laws/joint_trajectory_law.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/control/laws/desired_joints.hpp"
#include "core/control/laws/first_gains.hpp"
#include "core/control/laws/ros_pid.hpp"

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

class JointTrajectoryLaw final : public TorqueLaw {
 public:
  explicit JointTrajectoryLaw(const LawSetup& setup)
      : TorqueLaw(setup),
        feeds_forward_(jtc_gain(setup.gains, "ff_velocity_scale")),
        feeds_next_velocity_(rules_of(jtc_distro(setup.gains)).feeds_next_velocity),
        held_by_robot_(setup.model.compensates_gravity),
        period_(setup.period),
        desired_(setup.model.n(), setup.period) {
    if (setup.gains.controller == kJointTrajectoryVelocityController)
      drives_.emplace(setup.model, setup.period, setup.drives);
    const auto anti_windup = static_cast<std::size_t>(jtc_gain(setup.gains, "antiwindup")[0]);
    for (int i = 0; i < setup.model.n(); ++i) {
      RosPidGains& gains = gains_[static_cast<std::size_t>(i)];
      gains.p = jtc_gain(setup.gains, "p")[i];
      gains.i = jtc_gain(setup.gains, "i")[i];
      gains.d = jtc_gain(setup.gains, "d")[i];
      gains.i_max = jtc_gain(setup.gains, "i_clamp")[i];
      gains.i_min = -jtc_lower_i_clamp(setup.gains, i);
      gains.u_max = jtc_gain(setup.gains, "u_clamp_max")[i];
      gains.u_min = -jtc_gain(setup.gains, "u_clamp_min")[i];
      gains.anti_windup = kAntiWindups[anti_windup];
      gains.tracking_time = jtc_gain(setup.gains, "tracking_time")[i];
      gains.deadband = jtc_gain(setup.gains, "error_deadband")[i];
      const auto k = static_cast<std::size_t>(i);
      turns_[k] =
          wraps(rules_of(jtc_distro(setup.gains)).wraparound, setup.model.joints[k].limits.has_position,
                jtc_gain(setup.gains, "angle_wraparound")[i] != 0.0);
    }
  }

  void torque(const LawInput& in, JointVector& tau) override {
    const MotionPoint<JointVector> desired = desired_.next(in);
    const bool ahead =
        feeds_next_velocity_ && in.control.state == ControlState::kFollowPlan && !feeds_forward_.isZero(0.0);
    JointVector next = ahead ? in.scene.plan->at(in.time + period_).velocity : desired.velocity;
    if (ahead && in.scene.holds_plan && in.time + period_ > in.scene.plan->end()) next.setZero();
    command_.resize(feeds_forward_.size());
    for (Eigen::Index i = 0; i < command_.size(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double away = desired.position[i] - in.measured.q[i];
      const double error = turns_[k] ? std::remainder(away, 2.0 * M_PI) : away;
      command_[i] = feeds_forward_[i] * next[i] +
                    pids_[k].output(gains_[k], error, desired.velocity[i] - in.measured.qd[i], period_);
    }
    if (drives_ ? drives_->needs_weight() : held_by_robot_) gravity_torque(in.arm, weight_);
    if (drives_) {
      drives_->begin(command_, in.measured, weight_);
      drives_->torque(in.measured, tau);
    } else {
      tau = command_;
      if (held_by_robot_) tau += weight_;
    }
  }

  JointDrives* drives() override { return drives_ ? &*drives_ : nullptr; }

 private:
  std::array<RosPidGains, kMaxJoints> gains_{};
  std::array<RosPid, kMaxJoints> pids_{};
  std::array<bool, kMaxJoints> turns_{};  ///< true: the joint takes the short way round
  JointVector feeds_forward_;
  bool feeds_next_velocity_;  ///< false: the feed-forward takes the desired velocity of this period
  JointVector command_;       ///< efforts or velocities
  std::optional<JointDrives> drives_;
  bool held_by_robot_;  ///< the robot itself compensates gravity
  JointVector weight_;
  double period_;
  DesiredJoints desired_;
};

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
                         "size of u_clamp_min, which is negative: the smallest command, without the "
                         "feed-forward",
                         kNoClamp)),
      not_tuned(own_gain(kJoints, names[10], units[3],
                         "size of i_clamp_min, which is negative, if it differs from i_clamp; 0: the same as "
                         "i_clamp",
                         0.0)),
      wraparound,
      distro};
}

std::unique_ptr<TorqueLaw> make_law(const LawSetup& setup) {
  return std::make_unique<JointTrajectoryLaw>(setup);
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

ControllerKind joint_trajectory_controller() {
  return {
      kJointTrajectoryController,
      "ROS's joint_trajectory_controller with effort commands: a PID for each joint along a joint trajectory",
      {},
      jtc_fields(kJointTrajectoryController, {"N m/rad", "N m/(rad s)", "N m s/rad", "N m", "N m s/rad"},
                 100.0, 10.0),
      make_law,
      [](const RobotModel& robot, const JointVector& q, Gains& gains) {
        critically_damped(robot, q, own(gains, "jtc_p"), own(gains, "jtc_d"));
        own(gains, "jtc_i") = kIntegralRate * own(gains, "jtc_p");
        without_velocity_limits(gains);
      }};
}

ControllerKind joint_trajectory_velocity_controller() {
  return {kJointTrajectoryVelocityController,
          "ROS's joint_trajectory_controller with velocity commands: a PID for each joint commands its "
          "simulated velocity drive",
          {},
          jtc_fields(kJointTrajectoryVelocityController, {"1/s", "1/s^2", "1", "rad/s", "1"},
                     kOuterRate * kDriveRate, 0.0),
          make_law,
          [](const RobotModel&, const JointVector&, Gains& gains) { without_velocity_limits(gains); }};
}

}  // namespace armtune::internal
