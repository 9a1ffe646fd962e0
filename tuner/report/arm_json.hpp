#pragma once
// An arm as JSON: the `robot` of a page's data and of scene.json.

#include "sim/yaml/document.hpp"
#include "tuner/report/arm.hpp"
#include "tuner/report/json.hpp"

namespace armtune::report {

void write_arm(Json& json, const Arm& arm);

/// Throws InputError naming file, key, value and what is expected.
Arm read_arm(const yaml::Node& node);

}  // namespace armtune::report
