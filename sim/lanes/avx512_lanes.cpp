#include "sim/lanes/kinds.hpp"
#include "sim/lanes/packed_arm.hpp"

namespace armtune::internal {

std::unique_ptr<ArmLanes> make_avx512_lanes(const LaneKind& kind) {
  return std::make_unique<PackedArm<8>>(kind);
}

}  // namespace armtune::internal
