#pragma once
// Creates gaze targets (points at which the tool's z axis aims) that rest at random places. A scenario file
// requests them by the key `random`.

#include <cstdint>
#include <vector>

#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// Returns `count` points between low and high [m], named random_1, random_2 .., drawn by mt19937_64. A seed
/// gives the same points on every machine. A larger count appends points and does not change the others.
std::vector<NamedPath> random_targets(int count, const Vec3& low, const Vec3& high, std::uint64_t seed);

}  // namespace armtune::internal
