#pragma once
// Creates gaze targets that rest at random places. A scenario file requests them by the key `random`.

#include <cstdint>
#include <vector>

#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// Returns `count` points between low and high [m], named random_1, random_2 .., drawn by mt19937_64. A seed
/// gives the same points on every machine. The first points are the same for every count.
std::vector<NamedPath> random_targets(int count, const Vec3& low, const Vec3& high, std::uint64_t seed);

}  // namespace armtune::internal
