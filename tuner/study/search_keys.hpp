#pragma once
// Reads the keys of a study file that configure the search: its algorithms, its budget and its warm start.

#include "sim/yaml/document.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {

/// Sets the default algorithms and constraint handling, for a study that names no algorithm. They gave the
/// best results in the comparison by scripts/compare-algorithms, which is stored in results/algorithms.
void default_search(Study& study);

/// Reads the keys of `search`. If they name no algorithm, calls default_search first. Throws InputError with
/// file, line and key.
void read_search(const yaml::Node& node, Study& study);

/// Reads the keys of `warm_start`. The study's source, scenarios and parameters must be read already. Throws
/// InputError with file, line and key.
void read_warm_start(const yaml::Node& node, Study& study);

}  // namespace armtune::internal
