#pragma once
// What kinds of processors there are kernels for.

namespace armtune::internal {

enum class Processor {
  kAny,    ///< any x86-64, or whatever else the compiler knows
  kAvx2,   ///< x86-64-v3's 256-bit registers
  kAvx512  ///< x86-64-v4's 512-bit registers
};

constexpr const char* name(Processor processor) {
  return processor == Processor::kAvx512 ? "avx512" : processor == Processor::kAvx2 ? "avx2" : "any";
}

/// The best kind that this program has kernels for and this machine can run.
Processor best_processor();

/// Whether this machine can run the kernels of that kind, as they are compiled in this program.
bool runs_here(Processor processor);

}  // namespace armtune::internal
