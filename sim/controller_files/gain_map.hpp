#pragma once
// A gain map is a file that binds numbers of any other YAML file to gains of one of armtune's controllers.
// With it, armtune can tune the parameter file of a controller that it does not know, if the control law of
// that controller is one that armtune has too.

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/controller_files/placed_gain.hpp"
#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

/// The content of a gain map.
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
///   - map: {PLACE: GAIN, ...} or {PLACE: {gain: GAIN, factor: NUMBER}, ...}, see GainPlace. A place
///     has a list of n numbers for a gain of n joints, a list of six for a gain of the task, or one number. A
///     list of gains instead of GAIN binds all of them to the same number;
///   - rate: control rate [Hz] (default: unknown);
///   - ros1: true if ROS 1 reads the file, so that changed numbers are written in a form that ROS 1 can read
///     (default: false).
/// Each further key is a gain that is not in the file with the numbers; its value is that of the gain. Throws
/// InputError "FILE:LINE: what".
GainMap gain_map(const std::string& text, const std::string& path);

/// Returns the gains for an arm with these joints, in their order. Gains that are not bound to numbers have
/// the values that the map gives as further keys, otherwise the defaults of the controller. Throws InputError
/// if the file has no number at a place, if a gain does not exist, or if two places are bound to the same
/// gain.
Gains mapped_gains(const RosController& controller, const std::string& file,
                   const std::vector<std::string>& joints);

/// Returns every number of the file that is a gain, with its value in `gains`.
std::vector<PlacedGain> placed_mapped_gains(const RosController& controller, const std::string& file,
                                            const Gains& gains, const std::vector<std::string>& joints);

}  // namespace armtune::internal
