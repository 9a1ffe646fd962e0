#pragma once
// Computes how a point of the arm moves when one joint moves. The constraints and costs of a plan store this
// derivative in their Jacobians.

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

/// Returns dp/dq_i: the derivative of a point p [m] with respect to the position of joint i. The point
/// belongs to the arm beyond this joint.
inline Vec3 point_rate(const JointAxis& axis, const Vec3& p) {
  return axis.turns ? Vec3(axis.z.cross(p - axis.p)) : axis.z;
}

/// Writes the three entries of d into one column of a matrix that is stored row by row. columns: number of
/// columns of the matrix.
inline void put(double* rows, int columns, int column, const Vec3& d) {
  for (int i = 0; i < 3; ++i) rows[i * columns + column] = d[i];
}

}  // namespace armtune::internal
