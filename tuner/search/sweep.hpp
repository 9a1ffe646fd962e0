#pragma once
// Lists the points of a study's coarse sweep. The sweep is a small grid around the start gains, like the
// values that a person would try by hand. Along each axis of the grid, some gains are multiplied by a common
// factor.

#include <vector>

#include "tuner/study/study.hpp"

namespace armtune::internal {

/// Returns the search coordinates of every combination of the axes' factors. The factor of the first axis
/// changes fastest. Returns no points if the study has no axes.
std::vector<std::vector<double>> sweep_points(const Study& study);

}  // namespace armtune::internal
