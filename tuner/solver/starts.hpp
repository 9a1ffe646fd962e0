#pragma once
// Computes starting points for several local searches. The points cover the searched range evenly.

#include <cstdint>
#include <vector>

#include "tuner/solver/solver.hpp"

namespace armtune::internal {

/// Returns `count` points of a low-discrepancy sequence between the bounds of the problem. This is
/// Richtmyer's sequence (1951), in which coordinate i advances by the fractional part of the square root of
/// the i-th prime, relative to its range. The sequence is shifted at random (Cranley and Patterson, 1976).
/// The same seed gives the same points. A smaller count gives the first points of the same sequence.
std::vector<std::vector<double>> spread_starts(const SolverProblem& problem, std::size_t count,
                                               std::uint64_t seed);

}  // namespace armtune::internal
