#pragma once
// The aim of the tool: a target at which its z axis points, or a given orientation. For the control laws,
// both are converted to the turn from the tool's present orientation to the desired one, and to the angular
// velocity and acceleration of the desired orientation.

#include "core/trajectory/gaze_motion.hpp"
#include "core/trajectory/slerp.hpp"

namespace armtune::internal {

struct ToolAim {
  MotionPoint<Vec3> target{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< motion in the base frame [m]
  const OrientationPoint* orientation = nullptr;                       ///< replaces the target if not null
  /// True if only the z axis of `orientation` matters, so that the turn about it is free as in a gaze.
  bool axis_only = false;

  /// Returns the rotation vector [rad, base frame] from the tool's orientation to the desired one. For a
  /// target, or if axis_only is true, it is the shortest turn of the tool's z axis.
  Vec3 turn(const Mat3& R_0T, const Vec3& p_0T) const {
    if (orientation == nullptr) return gaze_turn(R_0T, p_0T, target.position);
    if (axis_only) return gaze_turn(R_0T, Vec3::Zero(), orientation->orientation * Vec3::UnitZ());
    return rotation_log(orientation->orientation * Eigen::Quaterniond(R_0T).conjugate());
  }

  /// Returns the turn rate of the desired orientation. tool: motion of the tool, base frame.
  TurnRate rate(const MotionPoint<Vec3>& tool) const {
    if (orientation != nullptr && !axis_only)
      return {orientation->angular_velocity, orientation->angular_acceleration};
    return direction_rate(direction(tool));
  }

  /// Returns the turn from the fixed orientation R_0F to the aim. If an orientation is given and axis_only is
  /// false, the result is the equivalent rotation vector nearest to its previous value `last`. Without this,
  /// the vector would jump at half a turn, because the turn in the opposite direction becomes shorter there.
  Vec3 turn_on(const Mat3& R_0F, const Vec3& p_0T, const Vec3& last) const {
    Vec3 phi = turn(R_0F, p_0T);
    if (orientation == nullptr || axis_only) return phi;
    const Vec3 on = nearest_rotation_vector(phi, last);
    return on.norm() < kMostTurn ? on : phi;
  }

  /// Returns `turn_on` with its derivatives.
  MotionPoint<Vec3> turn_motion(const Mat3& R_0F, const MotionPoint<Vec3>& tool, const Vec3& last) const {
    if (orientation != nullptr && !axis_only)
      return rotation_vector_motion(turn_on(R_0F, tool.position, last), rate(tool));
    return gaze_turn_motion(R_0F, direction(tool));
  }

 private:
  /// Largest turn [rad] that turn_on continues from `last`. Near a whole turn, a rotation vector does not
  /// determine an axis.
  static constexpr double kMostTurn = 1.8 * M_PI;

  /// Returns the desired direction of the tool's z axis, with its derivatives.
  MotionPoint<Vec3> direction(const MotionPoint<Vec3>& tool) const {
    if (orientation == nullptr) return gaze_direction(tool, target);
    const Vec3& w = orientation->angular_velocity;
    const Vec3 u = orientation->orientation * Vec3::UnitZ();
    const Vec3 u_dot = w.cross(u);
    return {u, u_dot, orientation->angular_acceleration.cross(u) + w.cross(u_dot)};
  }
};

}  // namespace armtune::internal
