#pragma once
// Where the tool is to be turned: at a target, or to an orientation that is given. To the laws both are a
// turn from where the tool is, and the rates at which that goes on.

#include "core/trajectory/gaze_motion.hpp"
#include "core/trajectory/slerp.hpp"

namespace armtune::internal {

struct ToolAim {
  MotionPoint<Vec3> target{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< of the gaze, base frame [m]
  const OrientationPoint* orientation = nullptr;                       ///< in its place
  /// The turn about the tool's z axis is free, of an orientation as of a gaze.
  bool axis_only = false;

  /// Rotation vector [rad, base frame] from the tool's orientation to the wanted one; of a gaze, or of an
  /// axis, the shortest.
  Vec3 turn(const Mat3& R_0T, const Vec3& p_0T) const {
    if (orientation == nullptr) return gaze_turn(R_0T, p_0T, target.position);
    if (axis_only) return gaze_turn(R_0T, Vec3::Zero(), orientation->orientation * Vec3::UnitZ());
    return rotation_log(orientation->orientation * Eigen::Quaterniond(R_0T).conjugate());
  }

  /// At which the wanted orientation goes on, for a tool that moves like this.
  TurnRate rate(const MotionPoint<Vec3>& tool) const {
    if (orientation != nullptr && !axis_only)
      return {orientation->angular_velocity, orientation->angular_acceleration};
    return direction_rate(direction(tool));
  }

  /// `turn` from a frame that stands; of a whole orientation the rotation vector nearest to `last`, what it
  /// was before: past half a turn there is a shorter way, and taking it would be a jump.
  Vec3 turn_on(const Mat3& R_0F, const Vec3& p_0T, const Vec3& last) const {
    Vec3 phi = turn(R_0F, p_0T);
    if (orientation == nullptr || axis_only) return phi;
    const Vec3 on = nearest_rotation_vector(phi, last);
    return on.norm() < kMostTurn ? on : phi;
  }

  /// `turn_on` with its derivatives.
  MotionPoint<Vec3> turn_motion(const Mat3& R_0F, const MotionPoint<Vec3>& tool, const Vec3& last) const {
    if (orientation != nullptr && !axis_only)
      return rotation_vector_motion(turn_on(R_0F, tool.position, last), rate(tool));
    return gaze_turn_motion(R_0F, direction(tool));
  }

 private:
  /// Near a whole turn a rotation vector tells no axis.
  static constexpr double kMostTurn = 1.8 * M_PI;

  /// Where the tool's z axis is to point, with its derivatives.
  MotionPoint<Vec3> direction(const MotionPoint<Vec3>& tool) const {
    if (orientation == nullptr) return gaze_direction(tool, target);
    const Vec3& w = orientation->angular_velocity;
    const Vec3 u = orientation->orientation * Vec3::UnitZ();
    const Vec3 u_dot = w.cross(u);
    return {u, u_dot, orientation->angular_acceleration.cross(u) + w.cross(u_dot)};
  }
};

}  // namespace armtune::internal
