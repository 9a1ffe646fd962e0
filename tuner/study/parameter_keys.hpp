#pragma once
// Private to tuner/study: which gains a study tunes, as its file says it.

#include <string>
#include <vector>

#include "sim/yaml/document.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {

/// The entries of `parameters`; without the key (null) all gains that are searched by default, between their
/// default bounds. start: what they are where the file does not say. orientation: whether any scenario holds
/// one; where none does, gains of it are not searched by default. Throws InputError with file, line and key.
ParameterSpace read_space(const yaml::Node* node, const Gains& start, const std::vector<std::string>& joints,
                          bool orientation);

/// The axes of `sweep`, over parameters of the space. all: every gain of the arm. Throws InputError with
/// file, line and key.
std::vector<SweepAxis> read_sweep(const yaml::Node& node, const std::vector<GainEntry>& all,
                                  const ParameterSpace& space);

}  // namespace armtune::internal
