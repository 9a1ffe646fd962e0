#include <algorithm>
#include <optional>

#include "core/control/laws/drive_output.hpp"
#include "core/control/laws/position_servo.hpp"
#include "core/control/laws/velocity_drive.hpp"
#include "core/robot/dynamics.hpp"
#include "tuner/validation/command_follower.hpp"
#include "tuner/validation/held_commands.hpp"
#include "tuner/validation/motion_windows.hpp"

namespace armtune::internal {
namespace {

/// Time before a window over which the servo runs [s]. Its slowest settings decay within 0.2 s.
constexpr double kServoRun = 1.5;

/// The velocity drives of the robot, and the position loops in front of them, as in JointDrives. Unlike
/// those, they can start with the arm in motion.
class DriveFollower final : public CommandFollower {
 public:
  DriveFollower(const RobotModel& model, const MotionCommands& commands, double step)
      : chain_(model.chain),
        commands_(commands),
        takes_positions_(commands.kind == CommandKind::kPosition),
        robot_holds_(model.compensates_gravity),
        effort_(model.effort_limits()),
        velocity_(model.velocity_limits()),
        position_gain_(model.drive_position_gain.size() > 0
                           ? model.drive_position_gain
                           : JointVector::Constant(model.n(), kDrivePositionGain)),
        gains_(drive_gains(model)),
        held_(commands),
        drives_(model),
        output_(model, step),
        step_(step),
        cycle_(median_step(commands.time)) {
    if (takes_positions_ && commands.servo) servo_.emplace(model, *commands.servo, step);
  }

  double step() const override { return step_; }

  void start(const ArmStart& from) override {
    begin_ = from.time;
    if (servo_) {
      const auto before = static_cast<long>(kServoRun / step_);
      servo_->start(held_.at(time_of(-before)));
      for (long k = -before; k < 0; ++k) servo_->step(held_.at(time_of(k)));
    }
    JointVector needed;
    forward_kinematics(chain_, from.q, poses_);
    inverse_dynamics(chain_, poses_, from.qd, from.qdd, needed);
    const std::optional<PositionServo> servo = servo_;
    const JointVector error = velocity(0, from.q).cwiseMax(-velocity_).cwiseMin(velocity_) - from.qd;
    servo_ = servo;  // the first step moves it again
    // The first step adds its error to the integral before the torque is computed.
    JointVector held = needed - (gains_.gain + step_ * gains_.integral).cwiseProduct(error);
    if (robot_holds_) {
      gravity_torque(chain_, poses_, weight_);
      held -= weight_;
    }
    drives_.hold(held);
    output_.start(needed);
  }

  void torque(long k, const JointVector& q, const JointVector& qd, JointVector& tau) override {
    drives_.torque(velocity(k, q), qd, step_, tau);
    if (robot_holds_) {
      forward_kinematics(chain_, q, poses_);
      gravity_torque(chain_, poses_, weight_);
      tau += weight_;
    }
    output_.pass(tau);
    tau = tau.cwiseMax(-effort_).cwiseMin(effort_);
  }

 private:
  double time_of(long k) const { return begin_ + (static_cast<double>(k) + 0.5) * step_; }

  /// Returns the command of the velocity drives in step k (n). Moves the servo, if there is one.
  JointVector velocity(long k, const JointVector& q) {
    const double t = time_of(k);
    if (!takes_positions_) return held_.at(t);
    JointVector from, rate;
    if (servo_) {
      from = servo_->position();
      servo_->step(held_.at(t));
      rate = (servo_->position() - from) / step_;
    } else {
      const Eigen::Index i = held_.index_at(t);
      const JointVector now = commands_.value.row(i).transpose();
      const JointVector last = commands_.value.row(std::max<Eigen::Index>(0, i - 1)).transpose();
      // The drives move from one position to the next in a cycle, as in cyclic synchronous position mode.
      const double since = t - 0.5 * step_ - commands_.time[static_cast<std::size_t>(i)];
      const double share = std::clamp(since / cycle_, 0.0, 1.0);
      from = last + share * (now - last);
      rate = (std::clamp((since + step_) / cycle_, 0.0, 1.0) - share) / step_ * (now - last);
    }
    return rate + position_gain_.cwiseProduct(from - q);
  }

  const Chain& chain_;
  const MotionCommands& commands_;
  bool takes_positions_;
  bool robot_holds_;
  JointVector effort_, velocity_;  ///< limits
  JointVector position_gain_;
  DriveGains gains_;
  HeldCommands held_;
  std::optional<PositionServo> servo_;
  VelocityDrives drives_;
  DriveOutput output_;
  double step_;
  double cycle_;  ///< median time between commands [s]
  double begin_ = 0.0;
  Poses poses_;
  JointVector weight_;
};

}  // namespace

std::unique_ptr<CommandFollower> make_drive_follower(const RobotModel& model, const MotionCommands& commands,
                                                     double step) {
  return std::make_unique<DriveFollower>(model, commands, step);
}

}  // namespace armtune::internal
