#pragma once
// The lists of algorithms and metrics that a study can name, for `armtune algorithms` and `armtune metrics`.

#include <string>

namespace armtune::internal::cli {

/// Returns every search algorithm with a line on when to use it, and the other keys below `search` in a study
/// file.
std::string algorithms_text();

/// Returns every metric with its unit and direction, and the metrics that can end a rollout early.
std::string metrics_text();

}  // namespace armtune::internal::cli
