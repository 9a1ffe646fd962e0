#pragma once
// Draws uniform random numbers by armtune's own arithmetic, so that a seed gives the same numbers everywhere.
// The distributions of the C++ standard library may differ between its implementations.

#include <random>

namespace armtune::internal {

/// Returns a number in [lower, upper) from 53 random bits.
inline double uniform(std::mt19937_64& generator, double lower, double upper) {
  constexpr double kStep = 0x1.0p-53;
  return lower + (upper - lower) * kStep * static_cast<double>(generator() >> 11U);
}

}  // namespace armtune::internal
