#pragma once
// Impedance obstacle avoidance (equations 9 and 10):
//   tau = sum_i J_i^T k_f,i sum_j f(i,j),   f = (1 - s/r_o)^2 d/|d|,   d = joint origin i - centre of j,
// s = |d| - radius of j. A chain with link_radius keeps its links away instead: d runs to the point of link i
// that is nearest to the centre, s ends at the link's surface, and J_i is that point's.

#include <cmath>
#include <limits>
#include <span>

#include "core/common/select.hpp"
#include "core/control/obstacle.hpp"
#include "core/robot/kinematics.hpp"

namespace armtune {

/// Repulsion by a surface `inside` [m] short of d, at most 1 long; zero from r_o on before the surface.
Vec3 repulsion(const Vec3& d, double influence_radius, double inside = 0.0);

/// The point nearest to p on link i: the straight line from its joint's origin to the next one's, of the last
/// to the tool's.
template <typename T>
Vec3T<T> nearest_on_link(const PosesT<T>& poses, int i, const Vec3T<T>& p) {
  const Vec3T<T>& from = poses.p_0B[static_cast<std::size_t>(i)];
  const Vec3T<T> line = (i + 1 < poses.n ? poses.p_0B[static_cast<std::size_t>(i) + 1] : poses.p_0T) - from;
  const T squared = dot3(line, line);
  const Vec3T<T> to_p = p - from;
  T share = dot3(to_p, line) / select(squared > T(0), squared, T(1));
  share = select(share > T(0), share, T(0));
  share = select(share < T(1), share, T(1));
  return from + share * line;
}

/// Smallest distance of any joint origin, or any link's surface, to any obstacle's surface [m], negative
/// where they meet; infinite without obstacles.
template <typename T>
T obstacle_distance(const ChainT<T>& chain, const PosesT<T>& poses, std::span<const ObstacleT<T>> obstacles) {
  using std::sqrt;
  const T infinity(std::numeric_limits<double>::infinity());
  const bool links = chain.link_radius.size() > 0;
  T least = infinity;
  for (const ObstacleT<T>& obstacle : obstacles) {
    T of_one = infinity;  // squared, of joint origins
    for (int i = 0; i < poses.n; ++i) {
      const Vec3T<T> line =
          (links ? nearest_on_link(poses, i, obstacle.center) : poses.p_0B[static_cast<std::size_t>(i)]) -
          obstacle.center;
      const T square = dot3(line, line);
      if (!links) {
        of_one = select(square < of_one, square, of_one);
        continue;
      }
      const T distance = sqrt(square) - chain.link_radius[i] - obstacle.radius;
      least = select(distance < least, distance, least);
    }
    if (links) continue;
    const T distance = sqrt(of_one) - obstacle.radius;
    least = select(distance < least, distance, least);
  }
  return least;
}

inline double obstacle_distance(const Chain& chain, const Poses& poses, std::span<const Obstacle> obstacles) {
  return obstacle_distance<double>(chain, poses, obstacles);
}

/// Repulsive joint torques (n) [N m]. Those of the fourth joint and up are zero, as published: the wrist
/// belongs to the gaze.
void obstacle_torque(const Chain& chain, const Poses& poses, std::span<const Obstacle> obstacles,
                     double influence_radius, const JointVector& force_gains, JointVector& tau);

}  // namespace armtune
