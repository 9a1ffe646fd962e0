#pragma once
// The lists that a study is written from: algorithms and metrics, and what `armtune tune --help` says below
// its options.

#include <string>

namespace armtune::internal::cli {

/// Bundled studies, where the lists are, and an example.
std::string tune_help();

/// Every search algorithm with a line on when to use it, and the other keys of a study's search.
std::string algorithms_text();

/// Every metric with its unit and direction, and those that can end a rollout early.
std::string metrics_text();

}  // namespace armtune::internal::cli
