#pragma once
// The kinds of processors for which the SIMD code of sim/lanes is compiled separately. The best kind is
// chosen when the program runs.

namespace armtune::internal {

enum class Processor {
  kAny,    ///< any x86-64, or any other processor
  kAvx2,   ///< the 256-bit registers of x86-64-v3
  kAvx512  ///< the 512-bit registers of x86-64-v4
};

constexpr const char* name(Processor processor) {
  return processor == Processor::kAvx512 ? "avx512" : processor == Processor::kAvx2 ? "avx2" : "any";
}

/// Returns the best kind for which this program has compiled code and which this machine can run.
Processor best_processor();

/// Returns true if this machine can run the code for that kind, as it is compiled in this program.
bool runs_here(Processor processor);

}  // namespace armtune::internal
