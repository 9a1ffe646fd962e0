#pragma once
// An arm read back from scene.json.

#include "sim/yaml/document.hpp"
#include "tuner/report/arm.hpp"

namespace armtune::report {

/// Throws InputError naming file, key, value and what is expected.
Arm read_arm(const yaml::Node& node);

}  // namespace armtune::report
