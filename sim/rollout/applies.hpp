#pragma once
// Decides which metrics apply to a scenario. A metric that applies but has no value after a rollout counts as
// failed. A metric that does not apply had nothing to measure and is ignored.

#include "sim/metrics/metric.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// Returns true if the metric applies to the scenario. It returns false for:
///   - clearances without obstacles, or without pairs of bodies of that kind,
///   - position margins of joints without limits,
///   - the gaze if the scenario aims at nothing, and reacquisition without a target switch,
///   - responses without the stimulus that they belong to,
///   - joint errors without a planned motion,
///   - the tool's errors if no task follows the planned motion, and its orientation errors if the task is the
///     position alone.
bool applies(Metric metric, const Scenario& scenario);

}  // namespace armtune::internal
