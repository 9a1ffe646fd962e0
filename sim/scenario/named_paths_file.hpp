#pragma once
// Reads the gaze targets (points at which the tool's z axis aims) and the obstacles of a scenario file, each
// with its name and its motion. Also reads the schedule, that is, the times at which the tool switches to
// another target.
//
// A base file is a scenario file whose keys another one inherits by its key `base`.

#include <string>
#include <vector>

#include "sim/scenario/scenario.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {

/// Reads a list of obstacles, each with a name, a path and the radius of its sphere: `radius` [m], by default
/// 0. The names of waypoint files that this reads are added to `inputs`.
std::vector<MovingObstacle> read_obstacles(const yaml::Node& node, std::vector<std::string>& inputs);

/// Reads a list of targets, or {random: {count, low, high, seed}}. Both forms share one key, so that either
/// replaces the targets of a base file as a whole.
std::vector<NamedPath> read_targets(const yaml::Node& node, std::vector<std::string>& inputs);

/// Reads [{at, target}, ...]: from `at` [s] on, the gaze is at the target of that name. Before the first
/// entry it is at the first target. The times must be above zero and increase, and every entry must change
/// the target. [] removes the schedule of a base file.
std::vector<TargetTurn> read_schedule(const yaml::Node& node, const std::vector<NamedPath>& targets);

}  // namespace armtune::internal
