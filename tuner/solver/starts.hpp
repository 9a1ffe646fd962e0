#pragma once
// Computes starting points for several local searches. They are spread evenly over the search box.

#include <cstdint>
#include <vector>

#include "tuner/solver/solver.hpp"

namespace armtune::internal {

/// Returns `count` points of a low-discrepancy sequence in the problem's box. In Richtmyer's sequence (1951),
/// coordinate i advances by the fractional part of the square root of the i-th prime. The sequence is shifted
/// at random (Cranley and Patterson, 1976). The same seed gives the same points, and a smaller count gives
/// the first of them.
std::vector<std::vector<double>> spread_starts(const SolverProblem& problem, std::size_t count,
                                               std::uint64_t seed);

}  // namespace armtune::internal
