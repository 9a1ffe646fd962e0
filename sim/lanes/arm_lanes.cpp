#include "sim/lanes/arm_lanes.hpp"

#include "sim/lanes/kinds.hpp"

namespace armtune::internal {

Processor best_processor() {
#if defined(ARMTUNE_LANES_X86)
  // All extensions for which avx512_lanes.cpp is compiled (sim/CMakeLists.txt).
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma")) {
    return Processor::kAvx512;
  }
  if (__builtin_cpu_supports("avx2")) return Processor::kAvx2;
#endif
  return Processor::kAny;
}

bool runs_here(Processor processor) {
#if defined(ARMTUNE_LANES_X86)
  return processor <= best_processor();
#else
  return processor <= Processor::kAvx512;  // here every file is compiled for any processor
#endif
}

int most_lanes(Processor processor) {
  return processor == Processor::kAvx512 ? 8 : processor == Processor::kAvx2 ? 4 : 2;
}

std::unique_ptr<ArmLanes> make_arm_lanes(const LaneKind& kind, int lanes, Processor processor) {
  if (lanes > 4 && processor == Processor::kAvx512) return make_avx512_lanes(kind);
  if (lanes > 2 && processor != Processor::kAny) return make_avx2_lanes(kind);
  return make_any_lanes(kind);
}

}  // namespace armtune::internal
