#pragma once
// The grid of levels for the search of a Pareto front. A level is a set of upper limits on all criteria but
// the first, which is minimised. Also the order in which the levels are searched.

#include <cstddef>
#include <vector>

namespace armtune::internal {

/// Returns every level of a grid with `axes` axes of `levels` each, as its index along each axis. The order
/// is serpentine: consecutive levels differ by one step along one axis.
std::vector<std::vector<std::size_t>> serpentine(std::size_t axes, std::size_t levels);

/// Divides the places 0 .. count-1 of this order into groups of up to four that are searched at once. First
/// comes every fourth place, then the places between, whose searches begin at what their neighbours found.
/// The result of a run depends on the groups, so they do not depend on the machine.
std::vector<std::vector<std::size_t>> searched_together(std::size_t count);

}  // namespace armtune::internal
