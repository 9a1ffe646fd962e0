#pragma once
// What a run records of the joint distribution from which its random arms were drawn.

#include <optional>
#include <string>
#include <vector>

#include "sim/scenario/perturbation.hpp"
#include "tuner/run/distribution_facts.hpp"

namespace armtune::internal {

/// Returns the part of run.json, or nothing if there is no distribution.
std::optional<DistributionFacts> distribution_facts(const Perturbation& perturbation);

/// Adds the path of the distribution's file, if there is one, to the inputs of a run.
void add_distribution(const Perturbation& perturbation, std::vector<std::string>& inputs);

}  // namespace armtune::internal
