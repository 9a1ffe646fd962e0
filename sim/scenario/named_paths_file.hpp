#pragma once
// What has a name and a path in scenario files: targets, when the gaze turns to which, and obstacles.

#include <string>
#include <vector>

#include "sim/scenario/scenario.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {

/// A list of paths with names, each with the radius of its body: `radius` [m], 0 where it is left out.
std::vector<MovingObstacle> read_obstacles(const yaml::Node& node, std::vector<std::string>& inputs);

/// A list of targets, or {random: {count, low, high, seed}}. One key for both, so that either stands whole
/// over a base's.
std::vector<NamedPath> read_targets(const yaml::Node& node, std::vector<std::string>& inputs);

/// [{at, target}, ...]: from `at` [s] on the gaze is at the target of that name. Times rise, and each turn is
/// another target's; [] over a base's is none.
std::vector<TargetTurn> read_schedule(const yaml::Node& node, const std::vector<NamedPath>& targets);

}  // namespace armtune::internal
