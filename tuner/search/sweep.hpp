#pragma once
// The coarse sweep of a study: the points that a person would try by hand.

#include <vector>

#include "tuner/study/study.hpp"

namespace armtune::internal {

/// Returns the search coordinates of every combination of the axes' factors, the first axis fastest; none
/// without axes.
std::vector<std::vector<double>> sweep_points(const Study& study);

}  // namespace armtune::internal
