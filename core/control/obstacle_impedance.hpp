#pragma once
// Impedance obstacle avoidance (equations 9 and 10):
//   tau = sum_i J_i^T k_f,i sum_j f(i,j),   f = (1 - |d|/r_o)^2 d/|d|,   d = joint origin i - centre of j.

#include <cmath>
#include <limits>
#include <span>

#include "core/common/select.hpp"
#include "core/robot/kinematics.hpp"

namespace armtune {

/// Repulsion of one obstacle on one point, at most 1 long; zero from r_o on.
Vec3 repulsion(const Vec3& d, double influence_radius);

/// Smallest distance of any joint origin to any centre [m]; infinite without obstacles.
template <typename T>
T obstacle_distance(const PosesT<T>& poses, std::span<const Vec3T<T>> centers) {
  using std::sqrt;
  T squared(std::numeric_limits<double>::infinity());
  for (int i = 0; i < poses.n; ++i) {
    for (const Vec3T<T>& center : centers) {
      const Vec3T<T> line = poses.p_0B[static_cast<std::size_t>(i)] - center;
      const T square = dot3(line, line);
      squared = select(square < squared, square, squared);
    }
  }
  return sqrt(squared);
}

inline double obstacle_distance(const Poses& poses, std::span<const Vec3> centers) {
  return obstacle_distance<double>(poses, centers);
}

/// Repulsive joint torques (n) [N m]. Those of the fourth joint and up are zero, as published: the wrist
/// belongs to the gaze.
void obstacle_torque(const Chain& chain, const Poses& poses, std::span<const Vec3> centers,
                     double influence_radius, const JointVector& force_gains, JointVector& tau);

}  // namespace armtune
