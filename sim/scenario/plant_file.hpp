#pragma once
// What a scenario file says of the arm as it really is, and of the camera.

#include <string>
#include <vector>

#include "sim/scenario/scenario.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal {

/// All throw InputError with file and line.
PlantConditions read_plant(const yaml::Node& node, const std::vector<std::string>& joints);
Payload read_payload(const yaml::Node& node);
Camera read_camera(const yaml::Node& node);

}  // namespace armtune::internal
