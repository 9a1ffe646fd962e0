#pragma once
// Creates simulators that each simulate several arms at once (SIMD). There is one function per register
// width. Each arm has one lane, that is, one element of every vector register.

#include <memory>

#include "sim/lanes/arm_lanes.hpp"

namespace armtune::internal {

std::unique_ptr<ArmLanes> make_any_lanes(const LaneKind& kind);     ///< 2 lanes, on any processor
std::unique_ptr<ArmLanes> make_avx2_lanes(const LaneKind& kind);    ///< 4 lanes
std::unique_ptr<ArmLanes> make_avx512_lanes(const LaneKind& kind);  ///< 8 lanes

}  // namespace armtune::internal
