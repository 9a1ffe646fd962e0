#pragma once
// Reads the key `stimulus` of a scenario file. It describes a test signal (a step or a sum of sines) by which
// the response of the control loop is measured.

#include "sim/scenario/stimulus.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal {

/// Reads {on: path or target, step: {offset, at}} or {on, sines: {direction, amplitude, base_period, orders,
/// from, periods}}. duration, control_period: those of the scenario [s]; the stimulus must fit into them.
/// Throws InputError.
Stimulus read_stimulus(const yaml::Node& node, double duration, double control_period);

}  // namespace armtune::internal
