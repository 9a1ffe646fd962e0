#pragma once
// Collects the motions of a controller study (controller_study.hpp). A motion is read from the user's file,
// or planned through joint goals if the file has no times.

#include <optional>
#include <string>
#include <vector>

#include "tuner/controller_study/controller_study.hpp"

namespace armtune::internal {

/// A motion, and the names of its scenario and files.
struct StudyMotion {
  std::string file;       ///< path of the user's file
  std::string name;       ///< name of the scenario: that of the file, with a number if it is taken
  JointSpline motion;     ///< in radians, metres and seconds
  std::string reference;  ///< path by which the scenario refers to the file with the motion
  std::string message;    ///< ROS message, if the joint motion is armtune's; otherwise empty
  bool of_tool = false;   ///< true if the file has waypoints of the tool
};

/// Reads a motion from each file of inputs.trajectories, or plans it. arm: gives the robot for which motions
/// are planned; its members `file` and `positions` are not used, because the goals come from the files.
/// Throws InputError. Returns nothing if planning was stopped.
std::optional<std::vector<StudyMotion>> study_motions(const ControllerStudyInputs& inputs, JointGoals arm);

/// Adds notes for the user on how the file of a motion was understood, such as a motion without velocities.
void add_notes(const StudyMotion& move, std::vector<std::string>& notes);

}  // namespace armtune::internal
