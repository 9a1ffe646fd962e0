#pragma once
// Private to tuner/study: how a study searches, as its file says it.

#include "sim/yaml/document.hpp"
#include "tuner/study/study.hpp"

namespace armtune {

/// The keys of `search`. Throws InputError with file, line and key.
void read_search(const yaml::Node& node, Study& study);

/// The keys of `warm_start`; the study's source, scenarios and parameters stand already. Throws InputError
/// with file, line and key.
void read_warm_start(const yaml::Node& node, Study& study);

}  // namespace armtune
