#pragma once
// How a study searches, as its file says it.

#include "sim/yaml/document.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {

/// How a study searches that names no algorithm: the winner of scripts/compare-algorithms, whose table and
/// profiles are results/algorithms.
void default_search(Study& study);

/// The keys of `search`, on top of default_search if they name no algorithm. Throws InputError with file,
/// line and key.
void read_search(const yaml::Node& node, Study& study);

/// The keys of `warm_start`; the study's source, scenarios and parameters stand already. Throws InputError
/// with file, line and key.
void read_warm_start(const yaml::Node& node, Study& study);

}  // namespace armtune::internal
