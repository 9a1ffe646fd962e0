#include "core/control/laws/joint_trajectory_law.hpp"

#include <array>
#include <cmath>

#include "core/control/laws/first_gains.hpp"
#include "core/control/laws/ros_pid.hpp"

namespace armtune::internal {
namespace {

constexpr double kIntegralRate = 1.0;  // 1/s, of P: an arm's weight is borne after some seconds
constexpr double kNoClamp = 1e6;       // N m, N: beyond any joint

class JointTrajectoryLaw final : public TorqueLaw {
 public:
  explicit JointTrajectoryLaw(const LawSetup& setup)
      : TorqueLaw(setup),
        feeds_forward_(own(setup.gains, "jtc_ff_velocity_scale")),
        held_by_robot_(setup.model.compensates_gravity),
        period_(setup.period),
        step_(JointVector::Zero(setup.model.n())) {
    const JointVector& clamp = own(setup.gains, "jtc_i_clamp");
    const bool winds_up = own(setup.gains, "jtc_antiwindup")[0] == 0.0;
    for (int i = 0; i < setup.model.n(); ++i) {
      RosPidGains& gains = gains_[static_cast<std::size_t>(i)];
      gains.p = own(setup.gains, "jtc_p")[i];
      gains.i = own(setup.gains, "jtc_i")[i];
      gains.d = own(setup.gains, "jtc_d")[i];
      gains.i_max = clamp[i];
      gains.i_min = -clamp[i];
      gains.anti_windup = winds_up ? AntiWindup::kOfContribution : AntiWindup::kOfIntegral;
      const auto k = static_cast<std::size_t>(i);
      turns_[k] = !setup.model.joints[k].limits.has_position;
    }
  }

  void torque(const LawInput& in, JointVector& tau) override {
    const MotionPoint<JointVector> desired = desired_motion(in);
    const bool ahead = in.control.state == ControlState::kFollowPlan && !feeds_forward_.isZero(0.0);
    const JointVector next = ahead ? in.scene.plan->at(in.time + period_).velocity : desired.velocity;
    tau.resize(feeds_forward_.size());
    for (Eigen::Index i = 0; i < tau.size(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double away = desired.position[i] - in.measured.q[i];
      // A joint without limits takes the short way.
      const double error = turns_[k] ? std::remainder(away, 2.0 * M_PI) : away;
      tau[i] = feeds_forward_[i] * next[i] +
               pids_[k].output(gains_[k], error, desired.velocity[i] - in.measured.qd[i], period_);
    }
    if (!held_by_robot_) return;
    gravity_torque(in.arm, weight_);
    tau += weight_;
  }

 private:
  /// What a trajectory has in this period. In states that follow none: the references, integrated from where
  /// the arm was.
  MotionPoint<JointVector> desired_motion(const LawInput& in) {
    const ControlOutput& control = in.control;
    if (control.state == ControlState::kFollowPlan) {
      // Which is held where a task's references take over.
      reference_ = control.planned.position;
      step_.setZero();
      follows_ = true;
      return control.planned;
    }
    // An obstacle's repulsion is to move the arm, not to stretch a spring.
    if (!follows_ || control.state == ControlState::kAvoidObstacles)
      reference_ = in.measured.q;
    else
      reference_ += step_;
    follows_ = true;
    step_ = period_ * control.reference.velocity;
    return {reference_, control.reference.velocity, control.reference.acceleration};
  }

  std::array<RosPidGains, kMaxJoints> gains_{};
  std::array<RosPid, kMaxJoints> pids_{};
  std::array<bool, kMaxJoints> turns_{};  ///< joint without position limits
  JointVector feeds_forward_;
  bool held_by_robot_;  ///< its weight, as its own model has it
  JointVector weight_;
  double period_;
  JointVector reference_, step_;
  bool follows_ = false;  ///< references, in the last period
};

}  // namespace

ControllerKind joint_trajectory_controller() {
  constexpr auto kJoints = GainShape::kJoints;
  return {
      kJointTrajectoryController,
      "ROS's joint_trajectory_controller with effort commands: a PID for each joint along a joint trajectory",
      {},
      {own_gain(kJoints, "jtc_p", "N m/rad", "p of each joint on its position error", 100.0),
       own_gain(kJoints, "jtc_i", "N m/(rad s)", "i of each joint on its position error", 0.0),
       own_gain(kJoints, "jtc_d", "N m s/rad", "d of each joint on its velocity error", 10.0),
       not_tuned(own_gain(kJoints, "jtc_i_clamp", "N m",
                          "i_clamp: what the integral contributes at most; the default binds no joint",
                          kNoClamp)),
       not_tuned(own_gain(kJoints, "jtc_ff_velocity_scale", "N m s/rad",
                          "ff_velocity_scale: torque per desired velocity", 0.0)),
       not_tuned(own_gain(GainShape::kScalar, "jtc_antiwindup", "",
                          "1: the integral itself stays within i_clamp; 0: it grows on, and only what it "
                          "contributes is clamped",
                          1.0))},
      [](const LawSetup& setup) { return std::make_unique<JointTrajectoryLaw>(setup); },
      [](const RobotModel& robot, const JointVector& q, Gains& gains) {
        // Critically damped, poles at half the rate, for each joint with the others free.
        const JointVector d = kFirstRate * joint_inertia(robot, q);
        own(gains, "jtc_d") = d;
        own(gains, "jtc_p") = 0.25 * kFirstRate * d;
        own(gains, "jtc_i") = kIntegralRate * own(gains, "jtc_p");
        // It has neither.
        gains.velocity_margin = 0.0;
        gains.velocity_barrier_gain = 0.0;
      }};
}

}  // namespace armtune::internal
