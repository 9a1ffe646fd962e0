#pragma once
// Reads the control period and the duration of a scenario.

#include "sim/scenario/scenario.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {

/// Reads the keys `control_period`, `planned`, `duration`, `hold_end` and `goal_tolerance` of a scenario file
/// into the scenario, whose robot is known. Throws InputError with file, line and key.
void read_times(yaml::MapReader& map, Scenario& scenario);

}  // namespace armtune::internal
