#pragma once
// The floating-point arithmetic of this process. armtune's own code is compiled for every x86-64 processor.
// But the mathematical library of glibc has several variants of sin, exp, pow ..., for example with FMA or
// AVX2. It selects a variant that fits the processor, and the results of the variants differ in the last bit.
// armtune requests the variants that run on every x86-64 processor (the baseline), so that all machines
// compute the same results.

#include <string>

namespace armtune::internal {

/// The variants of sin, exp and similar functions that a process uses.
struct Arithmetic {
  std::string level;        ///< "baseline x86-64", or "of this processor" if the baseline is not available
  std::string fingerprint;  ///< hash of the results of elementary functions for fixed arguments
};

/// Returns the arithmetic of this process. The first call computes it, in less than a millisecond.
const Arithmetic& arithmetic();

/// Restarts the program in this process with GLIBC_TUNABLES set, unless the baseline is in use already. Call
/// it first in main, before any thread starts. If a restart is not possible, the process continues with the
/// arithmetic of its processor, and arithmetic() reports that.
void fix_arithmetic(char** argv);

/// Returns a value of GLIBC_TUNABLES that keeps the user's settings and requests the baseline. set: the
/// user's value.
std::string baseline_tunables(const std::string& set);

}  // namespace armtune::internal
