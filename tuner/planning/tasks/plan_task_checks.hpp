#pragma once
// Checks a planning task after its file was read: whether the task has the keys that it needs, has no others,
// and starts and ends within the limits of the arm. Private to tuner/planning/tasks.

#include <string>
#include <vector>

#include "sim/yaml/map_reader.hpp"
#include "tuner/planning/tasks/plan_task.hpp"

namespace armtune::internal {

/// True if the key has an effect in this task. key: goal, least_error, path_tolerance, gaze_threshold, hold
/// or end_gaze, which have no effect in some tasks.
bool has_effect(const std::string& key, const PlanTask& task);

/// Returns the node of joint i in a list or a map that yaml::joint_values has read.
const yaml::Node& node_of_joint(const yaml::Node& node, Eigen::Index i,
                                const std::vector<std::string>& joints);

/// Throws InputError at the node if the task cannot be planned in its scenario. Of the task, only the kind
/// and the scenario must be set before the call.
void check_task_scenario(const yaml::Node& scenario, const PlanTask& task);

/// Throws InputError with file, line and key if a key is missing or has no effect, or if the start or the
/// goal violates a limit of the arm. map: the task's file, in which every key has been read.
void check_plan_task(yaml::MapReader& map, const PlanTask& task);

}  // namespace armtune::internal
