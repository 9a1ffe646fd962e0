#pragma once
// Dominance among points with several costs, where lower costs are better. Finds the points that no other
// point beats in every cost, and the hypervolume.

#include <cstddef>
#include <vector>

namespace armtune::internal {

using Costs = std::vector<double>;

/// True if a is nowhere worse than b and somewhere better.
bool dominates(const Costs& a, const Costs& b);

/// Returns the indices of the points that no other dominates, ascending in the first cost. Of equal points it
/// returns the first. All points have the same size. Points with a NaN count as dominated.
std::vector<std::size_t> non_dominated(const std::vector<Costs>& points);

/// Returns the volume that the points dominate below a reference point, with each cost in units of the
/// reference's absolute value (Zitzler and Thiele, 1998). For costs above zero it is the share, between 0 and
/// 1, of the box between the origin and the reference that is dominated. It is exact, computed by slicing
/// along the last cost. Costs of the reference must be finite and not zero.
double hypervolume(const std::vector<Costs>& points, const Costs& reference);

}  // namespace armtune::internal
