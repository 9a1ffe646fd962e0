#pragma once
// Creates lanes: simulators of several arms in one vector register (SIMD), one function per register width.

#include <memory>

#include "sim/lanes/arm_lanes.hpp"

namespace armtune::internal {

std::unique_ptr<ArmLanes> make_any_lanes(const LaneKind& kind);     ///< 2 lanes, on any processor
std::unique_ptr<ArmLanes> make_avx2_lanes(const LaneKind& kind);    ///< 4 lanes
std::unique_ptr<ArmLanes> make_avx512_lanes(const LaneKind& kind);  ///< 8 lanes

}  // namespace armtune::internal
