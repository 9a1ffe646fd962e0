#pragma once
// Orientation errors for tasks in which the tool may turn freely about its z axis
// (TaskMask::kPositionAndAxis). The errors have no component about that axis. If they had one, gains that
// differ between axes would turn it into a tilt of the tool.

#include "core/trajectory/gaze.hpp"

namespace armtune::internal {

/// Returns the negative of the shortest turn of the tool's z axis onto the z axis of the desired orientation.
/// The result is a rotation vector [rad, base frame], perpendicular to both axes.
inline Vec3 axis_error(const Mat3& R_0T, const Eigen::Quaterniond& desired) {
  return -gaze_turn(R_0T, Vec3::Zero(), desired * Vec3::UnitZ());
}

/// Returns the part of an angular velocity [rad/s, base frame] that moves the tool's z axis.
inline Vec3 axis_rate(const Mat3& R_0T, const Vec3& w) {
  const Vec3 z = R_0T.col(2);
  return w - z.dot(w) * z;
}

}  // namespace armtune::internal
