#pragma once
// Lays out the grid of levels in the search for a Pareto front, and the order in which the levels are
// searched. A level is a set of upper limits, one for each criterion except the first, which is minimised.
// The grid has one axis for each of these limits.

#include <cstddef>
#include <vector>

namespace armtune::internal {

/// Returns every level of a grid with `axes` axes and `levels` steps along each axis. A level is given by its
/// indices, one per axis. The order is serpentine: consecutive levels differ by one step along one axis.
std::vector<std::vector<std::size_t>> serpentine(std::size_t axes, std::size_t levels);

/// Divides the places 0 to count - 1 of the serpentine order into groups of up to four places. The levels of
/// a group are searched at the same time. The first groups contain every fourth place. The groups after them
/// contain the places between, whose searches start from the results of their neighbours. The result of a run
/// depends on the groups. Therefore the groups do not depend on the number of processors.
std::vector<std::vector<std::size_t>> searched_together(std::size_t count);

}  // namespace armtune::internal
