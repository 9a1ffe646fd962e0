#pragma once
// Which arithmetic this process computes with. armtune's own code is compiled for every x86-64 processor;
// glibc's libm however takes variants of sin, exp, pow ... by processor (with FMA, AVX2), which differ in the
// last bit. So that mixed machines agree, the variants every x86-64 processor has are asked for.

#include <string>

namespace armtune::internal {

struct Arithmetic {
  std::string level;        ///< "baseline x86-64", or "of this processor" where that could not be had
  std::string fingerprint;  ///< hash of the bits of elementary functions over fixed arguments
};

/// Of this process; computed when first asked for, in less than a millisecond.
const Arithmetic& arithmetic();

/// To be called first in main, before any thread: starts the program anew in this process, with
/// GLIBC_TUNABLES set, unless libm is at the baseline already. Where that is not possible it goes on as it
/// is, and arithmetic() says so.
void fix_arithmetic(char** argv);

/// A value of GLIBC_TUNABLES that keeps what the user has set, with the baseline asked for.
std::string baseline_tunables(const std::string& set);

}  // namespace armtune::internal
