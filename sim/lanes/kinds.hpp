#pragma once
// One function per file of kernels.

#include <memory>

#include "sim/lanes/arm_lanes.hpp"

namespace armtune::internal {

std::unique_ptr<ArmLanes> make_any_lanes(const LaneKind& kind);     ///< 2, on any processor
std::unique_ptr<ArmLanes> make_avx2_lanes(const LaneKind& kind);    ///< 4
std::unique_ptr<ArmLanes> make_avx512_lanes(const LaneKind& kind);  ///< 8

}  // namespace armtune::internal
