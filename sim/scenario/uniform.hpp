#pragma once
// Draws uniform and normal random numbers by armtune's own arithmetic, so that a seed gives the same numbers
// with every implementation of the standard library.
// The distributions of the C++ standard library may differ between its implementations.

#include <cmath>
#include <cstdint>
#include <random>

namespace armtune::internal {

/// Returns a number in [lower, upper) from 53 random bits.
inline double uniform(std::mt19937_64& generator, double lower, double upper) {
  constexpr double kStep = 0x1.0p-53;
  return lower + (upper - lower) * kStep * static_cast<double>(generator() >> 11U);
}

/// Returns a standard normal number, from two uniform ones (Box and Muller, A note on the generation of
/// random normal deviates, 1958). Its magnitude is at most sqrt(106 ln 2) = 8.6.
inline double standard_normal(std::mt19937_64& generator) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(generator, 0.0, 1.0)));
  return radius * std::cos(uniform(generator, 0.0, 2.0 * M_PI));
}

/// Returns a generator whose numbers depend on (seed, sample) alone.
inline std::mt19937_64 generator_of(std::uint64_t seed, std::uint64_t sample) {
  constexpr std::uint64_t kLow = 0xFFFFFFFFU;
  std::seed_seq sequence{seed & kLow, seed >> 32U, sample & kLow, sample >> 32U};
  return std::mt19937_64(sequence);
}

}  // namespace armtune::internal
