#pragma once
// The levels of a front's criteria as a grid, and the way through it.

#include <cstddef>
#include <vector>

namespace armtune::internal {

/// Every level of a grid with `axes` axes of `levels` each, as its index along each: serpentine, so that a
/// level differs from the one before in one step along one axis.
std::vector<std::vector<std::size_t>> serpentine(std::size_t axes, std::size_t levels);

/// Places 0 .. count-1 of a way, in groups of up to four to be searched at once: first every fourth place,
/// then those between, which begin at what their neighbours found. Part of what a run does, so no function of
/// the machine.
std::vector<std::vector<std::size_t>> searched_together(std::size_t count);

}  // namespace armtune::internal
