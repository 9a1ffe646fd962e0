#pragma once
// Reads the keys of a study file that configure the search: its algorithms, its budget and its warm start.

#include "sim/yaml/document.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {

/// Sets the search of a study that names no algorithm. It is the search that won scripts/compare-algorithms;
/// the table and profiles of this comparison are in results/algorithms.
void default_search(Study& study);

/// Reads the keys of `search`, on top of default_search if they name no algorithm. Throws InputError with
/// file, line and key.
void read_search(const yaml::Node& node, Study& study);

/// Reads the keys of `warm_start`. The study's source, scenarios and parameters must be read already. Throws
/// InputError with file, line and key.
void read_warm_start(const yaml::Node& node, Study& study);

}  // namespace armtune::internal
