#include "sim/controller_files/controller_gains.hpp"

#include "core/control/laws/joint_impedance_law.hpp"
#include "core/control/laws/joint_trajectory_law.hpp"
#include "sim/controller_files/joint_impedance_file.hpp"
#include "sim/controller_files/joint_trajectory_file.hpp"

namespace armtune::internal {

bool has_parameter_file(const std::string& kind) {
  return kind == kJointImpedance || is_joint_trajectory_controller(kind);
}

Gains controller_gains(const RosController& controller, const std::string& file,
                       const std::vector<std::string>& joints) {
  return controller.layout == GainLayout::kImpedance ? joint_impedance_gains(controller, file, joints)
                                                     : joint_trajectory_gains(controller, file, joints);
}

std::vector<PlacedGain> placed_gains(const RosController& controller, const std::string& file,
                                     const Gains& gains, const std::vector<std::string>& joints) {
  return controller.layout == GainLayout::kImpedance
             ? placed_impedance_gains(controller, gains, joints)
             : placed_trajectory_gains(controller, file, gains, joints);
}

}  // namespace armtune::internal
