#pragma once
// Binds numbers of any YAML file to gains of one of armtune's controllers. With such a map armtune can tune
// the parameter file of a controller that it does not know, if one of its own control laws does the same.

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/controller_files/placed_gain.hpp"
#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

/// A map, as its file has it.
struct GainMap {
  std::string file;          ///< path of the file with the numbers
  RosController controller;  ///< without `all` and `parameters`
};

/// Returns true if the text is a map: it has the keys `controller`, `file` and `map`. Throws InputError if it
/// has keys of these names, but is not YAML.
bool is_gain_map(const std::string& text, const std::string& path);

/// Reads a map. Its keys are:
///   - controller: one of motion_controllers();
///   - file: the file with the numbers; a relative path begins in the folder of the map;
///   - map: {PLACE: GAIN, ...} or {PLACE: {gain: GAIN, factor: NUMBER}, ...}, see GainPlace; a place has a
///   list
///     of n numbers for a gain of n joints, of six for a gain of the task, or one number; in place of GAIN, a
///     list of gains binds all of them to the same number;
///   - rate: control rate [Hz] (default: unknown);
///   - ros1: true if ROS 1 reads the file; changed numbers are then written so that it can (default: false).
/// Further keys are gains that the file does not have, with their numbers. Throws InputError "FILE:LINE:
/// what".
GainMap gain_map(const std::string& text, const std::string& path);

/// Returns the gains that a file with such a map has, for an arm with these joints, in their order. Gains
/// that the map does not name have the defaults of the controller, or the values that the map gives. Throws
/// InputError if the file has no number at a place, if a gain does not exist, or if two places give the same.
Gains mapped_gains(const RosController& controller, const std::string& file,
                   const std::vector<std::string>& joints);

/// Returns every number of the file that is a gain, with its value in `gains`.
std::vector<PlacedGain> placed_mapped_gains(const RosController& controller, const std::string& file,
                                            const Gains& gains, const std::vector<std::string>& joints);

}  // namespace armtune::internal
