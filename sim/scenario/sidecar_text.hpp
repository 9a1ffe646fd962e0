#pragma once
// Writes the text of a robot YAML in which the user fills in what a URDF lacks, checks the nearest possible
// values in place of impossible ones, and decides on proposals for doubtful values.

#include <string>
#include <vector>

#include "core/robot/urdf_options.hpp"
#include "sim/scenario/plausibility.hpp"

namespace armtune::internal {

/// Returns a robot YAML, or lines to add to one. Each key is there once:
///   - each missing limit, mass and moment has a key without a value. Until the user fills it in, reading the
///     file reports it with its line. A missing centre of mass is written as zero;
///   - an inertia that no rigid body can have is replaced by the nearest possible one, with its distance from
///     the given one. Without a nearest mass or nearest moments, the key has no value;
///   - every doubt is a comment, and so is every value that is proposed in place of a doubtful one.
/// urdf: path for the key `urdf` at the top; empty: the text has no such key.
std::string sidecar_yaml(const std::string& urdf, const MissingData& missing,
                         const std::vector<Doubt>& found);

}  // namespace armtune::internal
