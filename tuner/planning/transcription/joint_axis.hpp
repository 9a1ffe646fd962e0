#pragma once
// Computes how a point of the arm moves when one joint moves. The constraints and costs of a plan store it in
// their Jacobians.

#include "core/robot/kinematics.hpp"

namespace armtune::internal {

/// A joint's z axis and origin in the base frame; `turns` is true for a revolute joint.
struct JointAxis {
  Vec3 z;
  Vec3 p;
  bool turns;
};

inline JointAxis axis_of(const Chain& chain, const Poses& poses, int joint) {
  const auto k = static_cast<std::size_t>(joint);
  return {poses.R_0B[k].col(2), poses.p_0B[k], chain.motion[k] == JointMotion::kRevolute};
}

/// Returns d p / d q_i of a point p beyond joint i.
inline Vec3 point_rate(const JointAxis& axis, const Vec3& p) {
  return axis.turns ? Vec3(axis.z.cross(p - axis.p)) : axis.z;
}

/// Writes d into one column of three rows, which have `columns` entries each.
inline void put(double* rows, int columns, int column, const Vec3& d) {
  for (int i = 0; i < 3; ++i) rows[i * columns + column] = d[i];
}

}  // namespace armtune::internal
