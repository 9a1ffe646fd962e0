#pragma once
// A study made of what a robot's user has already: the arm, the parameter file of its controller, and
// motions.

#include <string>
#include <vector>

namespace armtune::internal {

/// Files of a user's. Paths are from the current folder.
struct ControllerStudyInputs {
  std::string robot;                      ///< bundled name, robot YAML or URDF
  std::string controllers;                ///< ROS parameter file with a joint_trajectory_controller
  std::string node;                       ///< which controller of it; empty: the only one
  std::vector<std::string> trajectories;  ///< CSV files or ROS messages, one at least
  double rate = 0.0;                      ///< of the controller [Hz]; 0: the file's update_rate
  bool degrees = false;                   ///< angles in CSV files are in degrees, not in radians
};

/// What was written, and what is to be said of it.
struct ControllerStudyFiles {
  std::string study;                 ///< path of study.yaml
  std::vector<std::string> written;  ///< names in the folder
  std::vector<std::string> notes;    ///< what was assumed, a sentence each
};

/// Writes a study of the controller's gains into a new folder: study.yaml, a scenario for each motion, and,
/// where nobody gives the arm's rotor inertia, robot.yaml with an estimate. Files that are there already with
/// the same text stay. All of it is read before anything is written. Throws InputError that says what stands
/// in the way: also where the parameter file could not hold other gains, and if the folder holds anything
/// else.
ControllerStudyFiles write_controller_study(const ControllerStudyInputs& inputs, const std::string& folder);

}  // namespace armtune::internal
