#pragma once
// Paths in scenario files: named curves, or a sum of harmonics as it is.

#include <vector>

#include "sim/scenario/scenario.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune {

// clang-format off
/// One of these, in the base frame:
///
///   circle: {center, radius, period, normal: [0, 0, 1], start_deg: 0}
///   ellipse: {center, axis_1, axis_2, period, start_deg: 0}       semi-axes as vectors, from the first to the second
///   figure_eight: {center, length, width, period, start_deg: 0}   half of either as vectors, begun in the middle
///   hold: [x, y, z]
///   center, frequency, phase, terms: [{order, cos, sin}]          a sum of harmonics (harmonic_path.hpp)
///
/// start_deg is where on the curve it begins, of 360. Throws InputError with file, line and key.
// clang-format on
HarmonicPath read_path(yaml::MapReader& map);

/// A list of paths with names.
std::vector<NamedPath> read_named_paths(const yaml::Node& node);

/// A list of targets, or {random: {count, low, high, seed}}. One key for both, so that either stands whole
/// over a base's.
std::vector<NamedPath> read_targets(const yaml::Node& node);

}  // namespace armtune
