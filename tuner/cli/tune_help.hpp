#pragma once
// What `armtune tune --help` says below its options.

#include <string>

namespace armtune::cli {

/// Bundled studies, algorithms, gains, metrics, and the keys of a study that the options do not show.
std::string tune_help();

}  // namespace armtune::cli
