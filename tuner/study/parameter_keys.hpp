#pragma once
// Reads the keys of a study file that select the gains to tune and their bounds. Private to tuner/study.

#include <string>
#include <vector>

#include "sim/yaml/document.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {

/// Returns the search space that the entries of `parameters` describe. If the key is missing (node is null),
/// the space contains all gains that are tuned by default, between their default bounds. start: the start
/// gains; an entry can replace a value. task: true if any scenario has a task for the tool; if false, gains
/// that act only on tasks are not tuned by default. orientation: true if any scenario tracks an orientation;
/// if false, gains that act only on orientations are not tuned by default. Throws InputError with file, line
/// and key.
ParameterSpace read_space(const yaml::Node* node, const Gains& start, const std::vector<std::string>& joints,
                          bool task, bool orientation);

/// Reads the axes of `sweep`. Their parameters must be in the space. all: every gain of the arm. Throws
/// InputError with file, line and key.
std::vector<SweepAxis> read_sweep(const yaml::Node& node, const std::vector<GainEntry>& all,
                                  const ParameterSpace& space);

}  // namespace armtune::internal
