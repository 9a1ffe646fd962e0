#include "core/robot/rotor_estimate.hpp"

#include <algorithm>

namespace armtune::internal {

void estimate_rotors(RobotModel& model) {
  for (int i = 0; i < model.n(); ++i) {
    double& inertia = model.chain.rotor_inertia[i];
    if (inertia != 0.0) continue;
    const JointInfo& joint = model.joints[static_cast<std::size_t>(i)];
    inertia = kRotorTime * joint.limits.effort / joint.limits.velocity;
    model.estimated_rotors.push_back(joint.name);
  }
}

bool has_estimated_rotor(const RobotModel& model, int i) {
  const std::string& name = model.joints[static_cast<std::size_t>(i)].name;
  return std::count(model.estimated_rotors.begin(), model.estimated_rotors.end(), name) > 0;
}

}  // namespace armtune::internal
