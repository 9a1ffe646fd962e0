#pragma once
// Help texts for studies: the lists of algorithms and metrics that a study can name, and the text that
// `armtune tune --help` shows below its options.

#include <string>

namespace armtune::internal::cli {

/// Returns the names of bundled studies, the commands that print the lists, and an example.
std::string tune_help();

/// Returns every search algorithm with a line on when to use it, and the other keys of a study's search.
std::string algorithms_text();

/// Returns every metric with its unit and direction, and the metrics that can end a rollout early.
std::string metrics_text();

}  // namespace armtune::internal::cli
