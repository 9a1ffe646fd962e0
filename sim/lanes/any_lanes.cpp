#include "sim/lanes/kinds.hpp"
#include "sim/lanes/packed_arm.hpp"

namespace armtune {

std::unique_ptr<ArmLanes> make_any_lanes(const LaneKind& kind) {
  return std::make_unique<PackedArm<2>>(kind);
}

}  // namespace armtune
