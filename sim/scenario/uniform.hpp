#pragma once
// Uniform numbers by our own arithmetic: the standard leaves its distributions to the library, and a seed
// must name the same numbers everywhere.

#include <random>

namespace armtune::internal {

/// In [lower, upper): 53 random bits.
inline double uniform(std::mt19937_64& generator, double lower, double upper) {
  constexpr double kStep = 0x1.0p-53;
  return lower + (upper - lower) * kStep * static_cast<double>(generator() >> 11U);
}

}  // namespace armtune::internal
