#pragma once
// Which of many points are worth looking at: those that no other beats in everything. Costs: less is better.

#include <cstddef>
#include <vector>

namespace armtune::internal {

using Costs = std::vector<double>;

/// a is nowhere worse than b and somewhere better.
bool dominates(const Costs& a, const Costs& b);

/// Indices of the points that no other dominates, ascending in the first cost; of equal points the first. All
/// of one size; points with a NaN count as dominated.
std::vector<std::size_t> non_dominated(const std::vector<Costs>& points);

/// Volume that the points dominate below a reference point, each cost in units of the reference's absolute
/// value: for costs above zero the share, between 0 and 1, of the box between the origin and the reference
/// that is dominated (Zitzler and Thiele, 1998). Exact, by slicing along the last cost. Costs of the
/// reference are finite and not zero.
double hypervolume(const std::vector<Costs>& points, const Costs& reference);

}  // namespace armtune::internal
