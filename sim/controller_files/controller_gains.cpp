#include "sim/controller_files/controller_gains.hpp"

#include "core/control/laws/cartesian_impedance_law.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/joint_impedance_law.hpp"
#include "core/control/laws/joint_trajectory_law.hpp"
#include "core/control/laws/position_streaming_law.hpp"
#include "sim/controller_files/gain_map.hpp"
#include "sim/controller_files/joint_impedance_file.hpp"
#include "sim/controller_files/joint_trajectory_file.hpp"

namespace armtune::internal {

std::vector<std::string> joint_motion_controllers() {
  return {kJointTrajectoryController, kJointTrajectoryVelocityController, kJointImpedance,
          kPositionStreaming};
}

std::vector<std::string> motion_controllers() {
  std::vector<std::string> names = joint_motion_controllers();
  names.emplace_back(kCartesianImpedance);
  return names;
}

Gains joint_motion_gains(const std::string& kind, Eigen::Index n) {
  Gains gains;
  change_controller(gains, kind, static_cast<int>(n));
  gains.joint_space_gains_p = gains.joint_space_gains_d = JointVector::Zero(n);
  gains.force_control_gains = JointVector::Zero(n);
  return gains;
}

Gains controller_gains(const RosController& controller, const std::string& file,
                       const std::vector<std::string>& joints) {
  switch (controller.layout) {
    case GainLayout::kImpedance:
      return joint_impedance_gains(controller, file, joints);
    case GainLayout::kMapped:
      return mapped_gains(controller, file, joints);
    case GainLayout::kPidByJoint:
      break;
  }
  return joint_trajectory_gains(controller, file, joints);
}

std::vector<PlacedGain> placed_gains(const RosController& controller, const std::string& file,
                                     const Gains& gains, const std::vector<std::string>& joints) {
  switch (controller.layout) {
    case GainLayout::kImpedance:
      return placed_impedance_gains(controller, gains, joints);
    case GainLayout::kMapped:
      return placed_mapped_gains(controller, file, gains, joints);
    case GainLayout::kPidByJoint:
      break;
  }
  return placed_trajectory_gains(controller, file, gains, joints);
}

}  // namespace armtune::internal
