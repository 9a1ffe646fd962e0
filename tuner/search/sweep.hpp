#pragma once
// The coarse sweep of a study: what a person would try by hand.

#include <vector>

#include "tuner/study/study.hpp"

namespace armtune::internal {

/// Search coordinates of every combination of the axes' factors, the first axis fastest; none without axes.
std::vector<std::vector<double>> sweep_points(const Study& study);

}  // namespace armtune::internal
