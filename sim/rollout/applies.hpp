#pragma once
// Which metrics a scenario asks for at all: a metric without a value where it applies is a failure, elsewhere
// there was nothing to judge.

#include "sim/metrics/metric.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// False for clearance without obstacles, position margins of joints without limits, reacquisition without a
/// switch, responses without the stimulus they answer to, joint errors without a planned motion, and the
/// tool's where nothing comes after that.
bool applies(Metric metric, const Scenario& scenario);

}  // namespace armtune::internal
