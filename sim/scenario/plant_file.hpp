#pragma once
// Reads the parts of a scenario file that describe how the simulated arm (the plant) differs from the
// controller's model (payload, friction, noise, delay), and the camera that measures the targets.

#include <string>
#include <vector>

#include "sim/scenario/scenario.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal {

/// Reads the key `plant`. This and the next two functions throw InputError with file and line.
PlantConditions read_plant(const yaml::Node& node, const std::vector<std::string>& joints);
Payload read_payload(const yaml::Node& node);
Camera read_camera(const yaml::Node& node);

}  // namespace armtune::internal
