#include "core/control/laws/joint_drives.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

/// Rounding must not add a step.
constexpr double kRounding = 1e-9;

}  // namespace

int steps_in(double period, double frequency) {
  return std::max(1, static_cast<int>(std::ceil(period * frequency * (1.0 - kRounding))));
}

JointDrives::JointDrives(const RobotModel& model, double period, const DriveTiming& timing)
    : steps_(steps_in(period, timing.frequency)),
      step_(period / steps_),
      robot_holds_(model.compensates_gravity),
      effort_(model.effort_limits()),
      drives_(model),
      delay_(model.n(), timing.delay),
      output_(model, step_) {}

JointDrives::JointDrives(const RobotModel& model, double period, const DriveTiming& timing,
                         const ServoGains& servo, double position_gain)
    : JointDrives(model, period, timing) {
  position_gain_ = JointVector::Constant(model.n(), position_gain);
  if (model.drive_position_gain.size() > 0)
    position_gain_ = position_gain / kDrivePositionGain * model.drive_position_gain;
  servo_.emplace(model, servo, step_);
}

void JointDrives::begin(const JointVector& command, const JointState& measured, const JointVector& weight) {
  if (!begun_) {
    begun_ = true;
    if (servo_) {
      servo_->start(measured.q);
      delay_.fill(measured.q);
    }
    if (!robot_holds_) drives_.hold(weight);
    output_.start(weight);
  }
  commanded_ = delay_.pass(command);
  if (robot_holds_) held_weight_ = weight;
}

void JointDrives::torque(const JointState& measured, JointVector& tau) {
  if (servo_) {
    const JointVector from = servo_->position();
    servo_->step(commanded_);
    velocity_ = (servo_->position() - from) / step_ + position_gain_.cwiseProduct(from - measured.q);
  } else {
    velocity_ = commanded_;
  }
  drives_.torque(velocity_, measured.qd, step_, tau);
  if (robot_holds_) tau += held_weight_;
  output_.pass(tau);
  torque_ = tau;
}

void JointDrives::next(const JointState& measured, JointVector& commanded, JointVector& torque) {
  this->torque(measured, commanded);
  commanded += added_;
  torque = commanded.cwiseMax(-effort_).cwiseMin(effort_);
}

}  // namespace armtune::internal
