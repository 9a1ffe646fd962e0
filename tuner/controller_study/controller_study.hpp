#pragma once
// Creates a study, which is armtune's description of a tuning problem, from files that the user of a robot
// already has: a model of the arm, the ROS parameter file of its controller, and motions for it to follow.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/trajectory/joint_spline.hpp"
#include "sim/cell/clearance_model.hpp"
#include "sim/scenario/user_table.hpp"

namespace armtune::internal {

/// Joint positions (goals) that an arm reaches one after another. It stops at each of them.
struct JointGoals {
  std::string file;  ///< file that the goals come from, for messages
  std::shared_ptr<const RobotModel> robot;
  std::shared_ptr<const ClearanceModel> clearance;  ///< pairs of bodies that must not touch
  std::vector<JointVector> positions;               ///< n each, at least two [rad, m]
  bool ros2 = true;                                 ///< true: the result is for ROS 2; false: for ROS 1
  double speed = 1.0;                               ///< factor on the speed of the planned motion
};

/// A motion through joint goals. It begins at 0 s.
struct TimedGoals {
  JointSpline motion;   ///< its acceleration is linear between its points
  std::string message;  ///< the same motion as a trajectory_msgs/JointTrajectory in YAML
};
/// A function that plans a motion through joint goals. It returns nothing if it was stopped.
using GoalTiming = std::function<std::optional<TimedGoals>(const JointGoals&)>;

/// Positions, and perhaps orientations, that the tool of an arm passes at given times.
struct ToolWaypoints {
  UserTable file;
  std::shared_ptr<const RobotModel> robot;
  std::shared_ptr<const ClearanceModel> clearance;  ///< pairs of bodies that must not touch
  bool ros2 = true;                                 ///< true: the result is for ROS 2; false: for ROS 1
  double speed = 1.0;                               ///< factor on the speed of the motion
};
/// A function that finds a joint motion along waypoints of the tool.
using ToolMotion = std::function<TimedGoals(const ToolWaypoints&)>;

/// The user's files and options. Relative paths begin at the current folder.
struct ControllerStudyInputs {
  std::string robot;        ///< bundled name, robot YAML or URDF
  std::string controllers;  ///< ROS parameter file of the controller; empty: `kind` is used
  std::string node;         ///< name of the controller in the file; empty: the only one
  /// CSV files or ROS messages, at least one: joint motions, joint goals without times, or waypoints of the
  /// tool. A controller that tracks the tool needs waypoints of the tool.
  std::vector<std::string> trajectories;
  double rate = 0.0;     ///< rate of the controller [Hz]; 0: the one in the file (controller_rate.hpp)
  double speed = 1.0;    ///< factor on the speed of all motions
  bool degrees = false;  ///< true: angles in CSV files are in degrees, not in radians
  /// Largest stiffness of an impedance controller. For a stiffness of joints [N m/rad, N/m]: n numbers, or
  /// one for all joints. For a stiffness of the tool: two numbers, for translations [N/m] and rotations [N
  /// m], or six. Empty: the stiffness is not tuned, because the files do not tell how large it may become.
  std::vector<double> max_stiffness = {};
  GoalTiming timing = {};       ///< plans motions for files without times; empty: these are refused
  ToolMotion tool_motion = {};  ///< finds motions for files with waypoints; empty: these are refused
  /// Without a parameter file: one of motion_controllers() (controller_gains.hpp). Its start gains are
  /// computed from the arm, and `rate` must be given.
  std::string kind = {};
  /// Distribution of ROS whose rules the joint trajectory controller in the file follows. Empty: Jazzy for a
  /// ROS 2 file, Noetic for a ROS 1 file.
  std::string distro = {};
};

/// The files that were written, with notes for the user.
struct ControllerStudyFiles {
  std::string study;                 ///< path of study.yaml
  std::vector<std::string> written;  ///< names in the folder
  std::vector<std::string> notes;    ///< assumptions that were made, one sentence each
};

/// Writes a study of the controller's gains into a new folder:
///   - study.yaml, and a scenario for each motion;
///   - for each file without times or with waypoints of the tool, the ROS message with the joint motion; but
///     if the controller tracks the tool itself, the path of the tool and the joint positions at its start;
///   - gains.yaml with the start gains, if there is no parameter file;
///   - robot.yaml with an estimate of the arm's rotor inertia, if no file gives this inertia.
///
/// If the folder already contains exactly these files, they are kept. Reads all inputs before it writes
/// anything. Throws InputError with the reason if the study cannot be made, if tuned gains could later not be
/// written into the parameter file, or if the folder contains anything else. Returns nothing, and writes
/// nothing, if the planning of a motion was stopped.
std::optional<ControllerStudyFiles> write_controller_study(const ControllerStudyInputs& inputs,
                                                           const std::string& folder);

}  // namespace armtune::internal
