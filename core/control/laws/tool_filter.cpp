#include "core/control/laws/tool_filter.hpp"

#include "core/trajectory/rotation.hpp"

namespace armtune::internal {

void ToolFilter::start(double share) {
  share_ = share;
}

void ToolFilter::begin(const double* R_0T, const double* p_0T) {
  const Mat3 R = Eigen::Map<const Mat3>(R_0T);
  Eigen::Map<Vec3> position(position_);
  Eigen::Map<Eigen::Quaterniond> orientation(orientation_);
  position = Eigen::Map<const Vec3>(p_0T);
  orientation = Eigen::Quaterniond(R);
}

void ToolFilter::follow(const double* R_0T, const double* p_0T, const double* pose_error, double* e) {
  const Eigen::Map<const Vec3> p(p_0T);
  const Eigen::Map<const Vec6> error(pose_error);
  Eigen::Map<Vec3> position(position_);
  Eigen::Map<Eigen::Quaterniond> orientation(orientation_);
  Eigen::Map<Vec6> result(e);

  const Mat3 R = Eigen::Map<const Mat3>(R_0T);
  const Eigen::Quaterniond measured(R);
  const Eigen::Quaterniond desired = rotation_exp(-error.tail<3>()) * measured;
  position = share_ * position + (1.0 - share_) * (p - error.head<3>());
  orientation = orientation.slerp(1.0 - share_, desired);
  const Eigen::Quaterniond turn = orientation * measured.conjugate();
  result.head<3>() = p - position;
  result.tail<3>() = (turn.w() < 0.0 ? 1.0 : -1.0) * turn.vec();
}

}  // namespace armtune::internal
