#pragma once
// The reader of the key `stimulus` of a scenario file.

#include "sim/scenario/stimulus.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal {

/// Reads {on: path or target, step: {offset, at}} or {on, sines: {direction, amplitude, base_period, orders,
/// from, periods}}. duration, control_period: those of the scenario [s]; the stimulus must fit into them.
/// Throws InputError.
Stimulus read_stimulus(const yaml::Node& node, double duration, double control_period);

}  // namespace armtune::internal
