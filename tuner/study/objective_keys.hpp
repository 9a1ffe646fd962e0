#pragma once
// Reads the keys of a study file that say what is minimised and which limits are kept: `objective` and
// `constraints`. Private to tuner/study.

#include <vector>

#include "sim/yaml/document.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {

/// Returns the terms of `objective`. A term without scenarios counts in those to which its metric applies.
/// Throws InputError with file, line and key.
std::vector<ObjectiveTerm> read_objective(const yaml::Node& node, const std::vector<Scenario>& scenarios);

/// Returns the entries of `constraints`. Throws InputError with file, line and key.
std::vector<Constraint> read_constraints(const yaml::Node& node, const std::vector<Scenario>& scenarios);

/// Sets `hopeless` of all constraints to never, for a risk measure other than the worst arm. With such a
/// measure the other arms can compensate for one bad arm, so no rollout is hopeless. node: the key
/// `constraints`, whose entries are the first constraints. Throws InputError if one of them has a value of
/// `hopeless`.
void end_no_sample_early(const yaml::Node& node, std::vector<Constraint>& constraints);

}  // namespace armtune::internal
