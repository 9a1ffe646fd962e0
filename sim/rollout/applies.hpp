#pragma once
// Decides which metrics apply to a scenario. A metric that applies but has no value after a rollout counts as
// failed. A metric that does not apply had nothing to measure and is ignored.

#include "sim/metrics/metric.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// Returns true if the metric applies to the scenario. It returns false for:
///   - the obstacle clearance if there are no obstacles, and any other clearance if there are no pairs of
///     bodies of that kind,
///   - the position margin if no joint has position limits, and the ratio of the acceleration to its limit if
///     no joint has an acceleration limit,
///   - the gaze metrics if the task is only to stay where a planned motion ended (the tool then aims at
///     nothing), and the reacquisition time if the target never switches,
///   - a response metric if the scenario does not have the stimulus that it belongs to,
///   - the joint errors if there is no planned motion,
///   - the tool's errors if no task follows the planned motion,
///   - the tool's orientation errors also if the task prescribes the position alone.
bool applies(Metric metric, const Scenario& scenario);

}  // namespace armtune::internal
