#pragma once
// Computes two distances between an arm and the obstacles:
//   - obstacle_distance is the distance that the published controller uses. It counts the joint origins, and
//     not the tool.
//   - clearance is the distance that metrics and recordings use. It counts the tool tip as well.
// If the chain has link_radius, every link is a capsule. The axis of a capsule leads from the origin of the
// link's joint to the next joint's origin, or to the tool for the last link. Both distances are then measured
// from the surface of the nearest capsule. Distances are negative if arm and obstacle overlap, and infinite
// without obstacles.

#include <cmath>
#include <limits>
#include <span>

#include "core/common/select.hpp"
#include "core/control/obstacle.hpp"
#include "core/robot/kinematics.hpp"

namespace armtune::internal {

/// Returns the point nearest to p on link i. The link is the straight line from its joint's origin to the
/// next joint's origin, or to the tool's origin for the last link.
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

/// Returns the distance that the controller uses [m]. It is the smallest distance between an obstacle's
/// surface and a joint origin, or a link's surface if the chain has link_radius.
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

/// Returns the arm's clearance [m], which is the smaller of acted_on and the distance of the tool tip.
/// acted_on: obstacle_distance of the same arm and obstacles. For a chain with link_radius, acted_on is the
/// clearance already, since the last link ends at the tool.
template <typename T>
T clearance(const ChainT<T>& chain, const PosesT<T>& poses, std::span<const ObstacleT<T>> obstacles,
            const T& acted_on) {
  using std::sqrt;
  if (chain.link_radius.size() > 0) return acted_on;
  T least = acted_on;
  for (const ObstacleT<T>& obstacle : obstacles) {
    const Vec3T<T> line = poses.p_0T - obstacle.center;
    const T distance = sqrt(dot3(line, line)) - obstacle.radius;
    least = select(distance < least, distance, least);
  }
  return least;
}

inline double clearance(const Chain& chain, const Poses& poses, std::span<const Obstacle> obstacles) {
  return clearance<double>(chain, poses, obstacles, obstacle_distance<double>(chain, poses, obstacles));
}

}  // namespace armtune::internal
