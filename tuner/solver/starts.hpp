#pragma once
// Points to begin searches at, spread over a box.

#include <cstdint>
#include <vector>

#include "tuner/solver/solver.hpp"

namespace armtune::internal {

/// `count` points of a low-discrepancy sequence in the problem's box: Richtmyer's (1951), whose coordinate i
/// goes on by the fractional part of the square root of the i-th prime, shifted at random (Cranley and
/// Patterson, 1976). The same seed gives the same points, and fewer are the first of more.
std::vector<std::vector<double>> spread_starts(const SolverProblem& problem, std::size_t count,
                                               std::uint64_t seed);

}  // namespace armtune::internal
