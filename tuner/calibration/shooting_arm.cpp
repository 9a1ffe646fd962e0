#include "tuner/calibration/shooting_arm.hpp"

#include "core/control/laws/joint_drives.hpp"

namespace armtune::internal {

ShootingArm shooting_arm(const RobotModel& model) {
  ShootingArm arm{model, 0.0, JointVector::Ones(model.n()), JointVector::Zero(model.n())};
  arm.model.shapes.clear();
  arm.model.chain.link_radius.resize(0);
  const DriveGains gains = drive_gains(model);
  arm.model.drive_velocity_gain = gains.gain;
  arm.model.drive_velocity_integral = gains.integral;
  if (model.drive_position_gain.size() == 0)
    arm.model.drive_position_gain = JointVector::Constant(model.n(), kDrivePositionGain);
  return arm;
}

}  // namespace armtune::internal
