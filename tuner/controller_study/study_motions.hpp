#pragma once
// Collects the motions of a controller study (controller_study.hpp). A motion is read from the user's file,
// or planned through joint goals if the file has no times.

#include <optional>
#include <string>
#include <vector>

#include "sim/scenario/planned_motion.hpp"
#include "tuner/controller_study/controller_study.hpp"
#include "tuner/controller_study/tool_path.hpp"

namespace armtune::internal {

/// A motion, and the names of its scenario and files.
struct StudyMotion {
  std::string file;       ///< path of the user's file
  std::string name;       ///< name of the scenario: that of the file, with a number if it is taken
  JointSpline motion;     ///< in radians, metres and seconds
  std::string reference;  ///< path by which the scenario refers to the file with the motion
  /// Text of that file, if armtune writes it: a ROS message with the joint motion that armtune found, or the
  /// path of the tool; otherwise empty.
  std::string message;
  bool of_tool = false;  ///< true if the file has waypoints of the tool
  /// Path of the tool, for a controller that tracks the tool itself. `motion` then rests at its start.
  std::optional<ToolPath> path = {};
  std::string start_reference = {};  ///< with `path`: name of the file with the joint positions at the start
};

/// Reads a motion from each file of inputs.trajectories, or plans it. arm: gives the robot for which motions
/// are planned; its members `file` and `positions` are not used, because the goals come from the files.
/// segments: how the controller joins the points of a motion. Throws InputError. Returns nothing if planning
/// was stopped.
std::optional<std::vector<StudyMotion>> study_motions(const ControllerStudyInputs& inputs, JointGoals arm,
                                                      Segments segments);

/// Reads a path of the tool from each file of inputs.trajectories, for a controller that tracks the tool
/// itself. arm: gives the robot and its shape. period: control period [s]. Throws InputError if a file has no
/// waypoints of the tool, or if the arm cannot follow them.
std::vector<StudyMotion> tool_motions(const ControllerStudyInputs& inputs, const JointGoals& arm,
                                      double period);

/// Adds notes for the user on how the file of a motion was understood, such as a motion without velocities.
void add_notes(const StudyMotion& move, Segments segments, std::vector<std::string>& notes);

}  // namespace armtune::internal
