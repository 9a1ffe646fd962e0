#pragma once
// Reads the keys of a study file that concern robustness: the random arms to tune on (`robust`), the demanded
// stability margins (`margins`), and the thresholds of the checks after the search (`verdict`).

#include "sim/yaml/document.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {

/// Returns the set of random arms that the keys of `robust` describe. Each arm differs at random from the arm
/// of the scenario. The path of `distribution` is relative to the file of the node. Throws InputError with
/// file, line and key.
SampleSet read_samples(const yaml::Node& node, const std::vector<Scenario>& scenarios);

/// Adds the demands of the keys of `margins` to the study. For each demand, also adds one constraint over all
/// corners of the demand (corner.hpp). The study's scenarios and other constraints must be read already.
/// Throws InputError with file, line and key.
void read_margins(const yaml::Node& node, Study& study);

/// Returns the thresholds of `verdict`; keys that are left out keep their defaults. Throws InputError with
/// file, line and key.
VerdictThresholds read_thresholds(const yaml::Node& node);

}  // namespace armtune::internal
