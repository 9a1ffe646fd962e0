#pragma once
// The kinds of processors that have kernels of their own.

namespace armtune::internal {

enum class Processor {
  kAny,    ///< any x86-64, or any other processor
  kAvx2,   ///< the 256-bit registers of x86-64-v3
  kAvx512  ///< the 512-bit registers of x86-64-v4
};

constexpr const char* name(Processor processor) {
  return processor == Processor::kAvx512 ? "avx512" : processor == Processor::kAvx2 ? "avx2" : "any";
}

/// Returns the best kind that this program has kernels for and this machine can run.
Processor best_processor();

/// Returns true if this machine can run the kernels of that kind, as they are compiled in this program.
bool runs_here(Processor processor);

}  // namespace armtune::internal
