#pragma once
// Reads the keys of a study file that select the gains to tune and their bounds. Private to tuner/study.

#include <string>
#include <vector>

#include "sim/yaml/document.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {

/// Reads the entries of `parameters`. Without the key (null) it returns all gains that are searched by
/// default, between their default bounds. start: the values of gains that the file does not give.
/// orientation: true if any scenario tracks an orientation; otherwise its gains are not searched by default.
/// Throws InputError with file, line and key.
ParameterSpace read_space(const yaml::Node* node, const Gains& start, const std::vector<std::string>& joints,
                          bool orientation);

/// Reads the axes of `sweep`, over parameters of the space. all: every gain of the arm. Throws InputError
/// with file, line and key.
std::vector<SweepAxis> read_sweep(const yaml::Node& node, const std::vector<GainEntry>& all,
                                  const ParameterSpace& space);

}  // namespace armtune::internal
