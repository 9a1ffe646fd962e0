#pragma once
// The motions of a controller study: read from the user's files, or planned through joint goals if a file has
// no times.

#include <optional>
#include <string>
#include <vector>

#include "tuner/controller_study/controller_study.hpp"

namespace armtune::internal {

/// A motion, and what its scenario is called.
struct StudyMotion {
  std::string file;       ///< the user's
  std::string name;       ///< of the scenario: as the file, with a number if that name is taken
  JointSpline motion;     ///< in radians, metres and seconds
  std::string reference;  ///< how the scenario names the file with the motion
  std::string message;    ///< ROS message if the motion was planned through the file's joint goals, or empty
};

/// Reads a motion from each file of inputs.trajectories, or plans it. arm: without file and positions. Throws
/// InputError. Returns nothing if planning was stopped.
std::optional<std::vector<StudyMotion>> study_motions(const ControllerStudyInputs& inputs, JointGoals arm);

/// Adds notes on what is assumed of a motion, one sentence each.
void add_notes(const StudyMotion& move, std::vector<std::string>& notes);

}  // namespace armtune::internal
