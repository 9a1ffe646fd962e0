#include "tuner/validation/command_follower.hpp"

#include "core/robot/dynamics.hpp"
#include "tuner/validation/held_commands.hpp"

namespace armtune::internal {
namespace {

class TorqueFollower final : public CommandFollower {
 public:
  TorqueFollower(const RobotModel& model, const MotionCommands& commands, double step)
      : chain_(model.chain),
        adds_weight_(commands.robot_adds_weight),
        effort_(model.effort_limits()),
        held_(commands),
        step_(step) {}

  double step() const override { return step_; }
  void start(const ArmStart& from) override { begin_ = from.time; }
  void torque(long k, const JointVector& q, const JointVector& /*qd*/, JointVector& tau) override {
    // In the middle of the step, rounding of the times cannot select the wrong command.
    tau = held_.at(begin_ + (static_cast<double>(k) + 0.5) * step_);
    if (adds_weight_) {
      forward_kinematics(chain_, q, poses_);
      gravity_torque(chain_, poses_, weight_);
      tau += weight_;
    }
    tau = tau.cwiseMax(-effort_).cwiseMin(effort_);
  }

 private:
  const Chain& chain_;
  bool adds_weight_;
  JointVector effort_;
  HeldCommands held_;
  double step_;
  double begin_ = 0.0;
  Poses poses_;
  JointVector weight_;
};

}  // namespace

std::unique_ptr<CommandFollower> make_torque_follower(const RobotModel& model, const MotionCommands& commands,
                                                      double step) {
  return std::make_unique<TorqueFollower>(model, commands, step);
}

std::unique_ptr<CommandFollower> make_command_follower(const RobotModel& model,
                                                       const MotionCommands& commands, double sample_period) {
  const double step = sample_period / steps_in(sample_period, drive_frequency(model, 0.0));
  switch (commands.kind) {
    case CommandKind::kTorque:
      return make_torque_follower(model, commands, step);
    case CommandKind::kVelocity:
    case CommandKind::kPosition:
      return make_drive_follower(model, commands, step);
    case CommandKind::kReference:
      return make_controller_follower(model, commands);
  }
  return nullptr;
}

}  // namespace armtune::internal
