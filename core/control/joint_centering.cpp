#include "core/control/joint_centering.hpp"

namespace armtune::internal {

JointCentering joint_centering(const RobotModel& model, double rate) {
  JointCentering centering{JointVector::Zero(model.n()), JointVector::Zero(model.n())};
  for (int i = 0; i < model.n(); ++i) {
    const JointLimits& limits = model.joints[static_cast<std::size_t>(i)].limits;
    if (!limits.has_position) continue;
    centering.middle[i] = 0.5 * (limits.lower + limits.upper);
    centering.rate[i] = rate;
  }
  return centering;
}

}  // namespace armtune::internal
