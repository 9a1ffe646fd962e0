#include "core/control/laws/velocity_drive.hpp"

#include "core/control/laws/first_gains.hpp"

namespace armtune::internal {
namespace {

/// Returns the middle of each joint's range; zero for joints without limits.
JointVector middle(const RobotModel& model) {
  JointVector q = JointVector::Zero(model.n());
  for (int i = 0; i < model.n(); ++i) {
    const JointLimits& limits = model.joints[static_cast<std::size_t>(i)].limits;
    if (limits.has_position) q[i] = 0.5 * (limits.lower + limits.upper);
  }
  return q;
}

}  // namespace

DriveGains drive_gains(const RobotModel& model) {
  DriveGains gains{model.drive_velocity_gain, model.drive_velocity_integral};
  if (gains.gain.size() == 0) gains.gain = kDriveRate * joint_inertia(model, middle(model));
  if (gains.integral.size() == 0) gains.integral = kDriveIntegralRate * gains.gain;
  return gains;
}

JointVector drive_step(const RobotModel& model, const JointVector& q, double period) {
  return period * drive_gains(model).gain.cwiseQuotient(joint_inertia(model, q));
}

VelocityDrives::VelocityDrives(const RobotModel& model)
    : gains_(drive_gains(model)),
      velocity_(model.velocity_limits()),
      effort_(model.effort_limits()),
      integral_(JointVector::Zero(model.n())) {}

void VelocityDrives::hold(const JointVector& torque) {
  integral_ = torque.cwiseMax(-effort_).cwiseMin(effort_);
}

void VelocityDrives::torque(const JointVector& commanded, const JointVector& qd, double dt,
                            JointVector& tau) {
  tau = commanded.cwiseMax(-velocity_).cwiseMin(velocity_) - qd;  // the velocity error
  integral_ = (integral_ + dt * gains_.integral.cwiseProduct(tau)).cwiseMax(-effort_).cwiseMin(effort_);
  tau = gains_.gain.cwiseProduct(tau) + integral_;
}

}  // namespace armtune::internal
