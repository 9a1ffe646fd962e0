#pragma once
// Compares points with several costs, where lower costs are better. A point dominates another one if no cost
// is higher and at least one is lower. The points that no other one dominates are the Pareto front, and the
// hypervolume measures how good the front is.

#include <cstddef>
#include <vector>

namespace armtune::internal {

using Costs = std::vector<double>;

/// True if a dominates b.
bool dominates(const Costs& a, const Costs& b);

/// Returns the indices of the points that no other point dominates, ascending in the first cost. If several
/// points are equal, only the first is returned. All points have the same number of costs. Points with a NaN
/// are left out.
std::vector<std::size_t> non_dominated(const std::vector<Costs>& points);

/// Returns the hypervolume: the volume of all costs that are dominated by one of the points and lie below the
/// reference (Zitzler and Thiele, 1998). Each cost is divided by the absolute value of the reference's cost.
/// If all costs are above zero, the result is between 0 and 1. It is then the dominated share of the box
/// between the origin and the reference. The result is exact, because it is computed by slicing along the
/// last cost. The costs of the reference must be finite and not zero.
double hypervolume(const std::vector<Costs>& points, const Costs& reference);

}  // namespace armtune::internal
