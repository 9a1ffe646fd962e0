#pragma once
// Obstacles near an arm, and what its distance from them is by trying points.

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/control/obstacle.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal::test {

/// Around some joint origins of the arm at q, so that several joints feel several of them.
inline std::vector<Obstacle> random_obstacles(std::mt19937& generator, const Poses& poses) {
  std::vector<Obstacle> obstacles;
  for (int i = 0; i < poses.n; i += 2) {
    obstacles.push_back({poses.p_0B[static_cast<std::size_t>(i)] + random_vec3(generator, 0.15),
                         random_number(generator, 0.0, 0.02)});
  }
  return obstacles;
}

/// An arm whose links are as thick as the numbers.
inline Chain with_links(const Chain& chain, std::mt19937& generator) {
  Chain thick = chain;
  thick.link_radius = random_vector(generator, chain.n, 0.02).cwiseAbs();
  return thick;
}

/// Distance [m] of a link's axis from p, by trying points along it.
inline double distance_by_sampling(const Poses& poses, int i, const Vec3& p) {
  constexpr int kPoints = 20000;
  const Vec3 from = poses.p_0B[static_cast<std::size_t>(i)];
  const Vec3 to = i + 1 < poses.n ? poses.p_0B[static_cast<std::size_t>(i) + 1] : poses.p_0T;
  double least = HUGE_VAL;
  for (int k = 0; k <= kPoints; ++k) {
    const double share = static_cast<double>(k) / kPoints;
    least = std::min(least, ((1.0 - share) * from + share * to - p).norm());
  }
  return least;
}

}  // namespace armtune::internal::test
