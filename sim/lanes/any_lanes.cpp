#include "sim/lanes/kinds.hpp"
#include "sim/lanes/packed_arm.hpp"

namespace armtune::internal {

std::unique_ptr<ArmLanes> make_any_lanes(const LaneKind& kind) {
  return std::make_unique<PackedArm<2>>(kind);
}

}  // namespace armtune::internal
