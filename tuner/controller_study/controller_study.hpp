#pragma once
// Creates a study, which is armtune's description of a tuning problem, from files that the user of a robot
// already has: a model of the arm, the ROS parameter file of its controller, and motions for it to follow.

#include <string>
#include <vector>

namespace armtune::internal {

/// Files of the user. Relative paths begin at the current folder.
struct ControllerStudyInputs {
  std::string robot;                      ///< bundled name, robot YAML or URDF
  std::string controllers;                ///< ROS parameter file with a joint_trajectory_controller
  std::string node;                       ///< name of the controller in the file; empty: the only one
  std::vector<std::string> trajectories;  ///< CSV files or ROS messages, at least one
  double rate = 0.0;                      ///< rate of the controller [Hz]; 0: the file's update_rate
  bool degrees = false;                   ///< true: angles in CSV files are in degrees, not in radians
};

/// The files that were written, with notes for the user.
struct ControllerStudyFiles {
  std::string study;                 ///< path of study.yaml
  std::vector<std::string> written;  ///< names in the folder
  std::vector<std::string> notes;    ///< assumptions that were made, one sentence each
};

/// Writes a study of the controller's gains into a new folder: study.yaml, a scenario for each motion, and,
/// if no file gives the arm's rotor inertia, robot.yaml with an estimate. If the folder already holds exactly
/// these files, they are kept. Reads all inputs before it writes anything. Throws InputError with the reason
/// if the study cannot be made, if tuned gains could later not be written into the parameter file, or if the
/// folder holds anything else.
ControllerStudyFiles write_controller_study(const ControllerStudyInputs& inputs, const std::string& folder);

}  // namespace armtune::internal
