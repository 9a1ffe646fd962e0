#include "core/control/roll_centering.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

/// Share of the last joint's velocity limit that the roll may use.
constexpr double kShareOfVelocity = 0.1;
/// Cosine of the angle (2.5 degrees) within which the joint's axis counts as parallel to the tool's z axis.
constexpr double kParallel = 0.999;
constexpr double kLongestTimeConstant = 1.0;  // s

}  // namespace

RollCentering::RollCentering(const RobotModel& model, double gain, TaskMask mask) {
  if (gain <= 0.0 || mask != TaskMask::kPose || model.n() == 0) return;
  const auto last = static_cast<std::size_t>(model.n() - 1);
  const JointLimits& limits = model.joints[last].limits;
  // Bodies turn about their own z axis.
  const double cosine = model.chain.R_BT(2, 2);
  const bool revolute = model.chain.motion[last] == JointMotion::kRevolute;
  if (!revolute || !limits.has_position || std::abs(cosine) < kParallel) return;
  gain_ = gain;
  sign_ = cosine > 0.0 ? 1.0 : -1.0;
  middle_ = 0.5 * (limits.lower + limits.upper);
  fastest_ = kShareOfVelocity * limits.velocity;
  time_constant_ = std::min(kLongestTimeConstant, 0.25 / gain);
}

void RollCentering::step(const JointVector& q, double period, bool frozen_start) {
  const double offset = q[q.size() - 1] - middle_;
  const double wanted = -sign_ * fastest_ * std::tanh(gain_ * offset / fastest_);
  acceleration_ = (wanted - rate_) / time_constant_;
  rate_ += period * acceleration_;
  since_start_ = frozen_start ? since_start_ + period * rate_ : 0.0;
}

void RollCentering::add_to(OrientationPoint& desired) const {
  desired.orientation = desired.orientation * Eigen::AngleAxisd(since_start_, Vec3::UnitZ());
  const Vec3 z = desired.orientation * Vec3::UnitZ();
  desired.angular_acceleration += acceleration_ * z + rate_ * desired.angular_velocity.cross(z);
  desired.angular_velocity += rate_ * z;
}

}  // namespace armtune::internal
