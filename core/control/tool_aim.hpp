#pragma once
// The aim of the tool: a target to point at, or a given orientation. The laws treat both as a turn from the
// tool's present orientation, and the rates of that turn.

#include "core/trajectory/gaze_motion.hpp"
#include "core/trajectory/slerp.hpp"

namespace armtune::internal {

struct ToolAim {
  MotionPoint<Vec3> target{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< of the gaze, base frame [m]
  const OrientationPoint* orientation = nullptr;                       ///< in place of a target
  /// True if the turn about the tool's z axis is free, for an orientation as for a gaze.
  bool axis_only = false;

  /// Returns the rotation vector [rad, base frame] from the tool's orientation to the wanted one. For a gaze
  /// or an axis it is the shortest turn.
  Vec3 turn(const Mat3& R_0T, const Vec3& p_0T) const {
    if (orientation == nullptr) return gaze_turn(R_0T, p_0T, target.position);
    if (axis_only) return gaze_turn(R_0T, Vec3::Zero(), orientation->orientation * Vec3::UnitZ());
    return rotation_log(orientation->orientation * Eigen::Quaterniond(R_0T).conjugate());
  }

  /// Returns the turn rate of the wanted orientation, for a tool that moves as given.
  TurnRate rate(const MotionPoint<Vec3>& tool) const {
    if (orientation != nullptr && !axis_only)
      return {orientation->angular_velocity, orientation->angular_acceleration};
    return direction_rate(direction(tool));
  }

  /// Returns `turn` from a fixed frame. For a complete orientation it is the rotation vector nearest to
  /// `last`, its previous value: beyond half a turn there is a shorter way, and taking it would be a jump.
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
  /// Largest continued turn [rad]. Near a whole turn, a rotation vector does not determine an axis.
  static constexpr double kMostTurn = 1.8 * M_PI;

  /// Returns the wanted direction of the tool's z axis, with its derivatives.
  MotionPoint<Vec3> direction(const MotionPoint<Vec3>& tool) const {
    if (orientation == nullptr) return gaze_direction(tool, target);
    const Vec3& w = orientation->angular_velocity;
    const Vec3 u = orientation->orientation * Vec3::UnitZ();
    const Vec3 u_dot = w.cross(u);
    return {u, u_dot, orientation->angular_acceleration.cross(u) + w.cross(u_dot)};
  }
};

}  // namespace armtune::internal
