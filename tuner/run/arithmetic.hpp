#pragma once
// The floating-point arithmetic of this process. armtune's own code is compiled for every x86-64 processor.
// But glibc's libm selects variants of sin, exp, pow ... by processor (with FMA, AVX2), which differ in the
// last bit. So that different machines agree, armtune requests the variants that every x86-64 processor has.

#include <string>

namespace armtune::internal {

struct Arithmetic {
  std::string level;        ///< "baseline x86-64", or "of this processor" if that is not available
  std::string fingerprint;  ///< hash of the bits of elementary functions over fixed arguments
};

/// Returns the arithmetic of this process. The first call computes it, in less than a millisecond.
const Arithmetic& arithmetic();

/// Restarts the program in this process with GLIBC_TUNABLES set, unless libm is at the baseline already. Call
/// it first in main, before any thread starts. If a restart is not possible, the process continues as it is,
/// and arithmetic() reports that.
void fix_arithmetic(char** argv);

/// Returns a value of GLIBC_TUNABLES that keeps the user's settings and requests the baseline. set: the
/// user's value.
std::string baseline_tunables(const std::string& set);

}  // namespace armtune::internal
