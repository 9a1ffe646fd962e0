#pragma once
// A scenario describes one task that is simulated. It consists of the robot, the tool's path, the gaze
// targets (points at which the tool's z axis aims) with their schedule, the obstacles, and the differences
// between the real arm and the controller's model of it.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "core/control/obstacle.hpp"
#include "core/control/task_mask.hpp"
#include "core/robot/robot_model.hpp"
#include "core/trajectory/joint_spline.hpp"
#include "core/trajectory/path.hpp"
#include "core/trajectory/tool_orientation.hpp"
#include "sim/cell/clearance_model.hpp"
#include "sim/scenario/stimulus.hpp"

namespace armtune::internal {

struct NamedPath {
  std::string name;
  Path path;
};

/// An entry of the gaze schedule: from `at` [s] on, the gaze is at this target.
struct TargetTurn {
  double at = 0.0;
  std::size_t target = 0;  ///< index
};

/// The start value of theta, the dynamic parameters with which the controller computes torques. It is either
/// model_scale times the parameters of the robot's model, or it comes from a file. In both cases it is then
/// multiplied by `factors`.
struct ThetaStart {
  double model_scale = 0.0;  ///< 0: the controller starts without knowledge; 1: with the robot's model
  std::string file;          ///< YAML file with theta by name, read into `given`; empty: model_scale is used
  JointVector factors;       ///< one for the parameters of each link and its joint; n or empty (all 1)
  ParameterVector given{};   ///< 13 n, or empty
};

/// The differences between the plant (the simulated arm) and the controller's model of it, sensor noise, and
/// torque delay.
struct PlantConditions {
  double position_noise = 0.0;  ///< standard deviation of the white noise in each period [rad, m]
  double velocity_noise = 0.0;  ///< likewise [rad/s, m/s]
  /// Number of control periods by which torques are delayed. With controllers that command velocities or
  /// positions, the commands to the robot's drives are delayed instead, and the torques of the drives act at
  /// once.
  int torque_delay_periods = 0;
  /// Lowest rate at which the arm and the robot's drives are computed [Hz]. 0: drives run at kDriveFrequency
  /// (joint_drives.hpp), and without drives the arm moves in one step per control period.
  double rate = 0.0;
  Payload payload;  ///< at the tool, unknown to the controller
  /// Added to the friction of the model, unknown to the controller [N m s/rad, N s/m]; n or empty.
  JointVector viscous_friction;
  JointVector coulomb_friction;  ///< likewise [N m, N]
  JointVector mass_factors;      ///< factor on each link's mass, first moment and inertia; n or empty (all 1)
  JointVector inertia_factors;   ///< further factor on inertia about the centre of mass; n or empty (all 1)
  Eigen::Matrix3Xd center_offsets;  ///< of each link's centre of mass, link frame [m]; 3 x n or empty (all 0)
  JointVector rotor_factors;        ///< factor on each joint's rotor inertia; n or empty (all 1)
  JointVector encoder_offset;       ///< true minus measured positions [rad, m]; n or empty (all 0)
  /// The simulated arm before factors, payload and friction of this struct. Null: the robot's model.
  std::shared_ptr<const RobotModel> arm;
};

/// The camera that measures the positions of the gaze targets. The controller estimates their motion from
/// these noisy positions.
struct Camera {
  double noise = 0.0;       ///< standard deviation of each coordinate's white noise in each period [m]
  double bandwidth = 15.0;  ///< of the filter that estimates position, velocity, acceleration [rad/s]
};

/// The name that result files use for all scenarios together. No scenario may have it.
inline constexpr const char* kAllScenarios = "all";

struct Scenario {
  std::string name;
  std::string description;
  std::string source;               ///< path of the scenario file
  std::vector<std::string> inputs;  ///< all files that were read: scenarios, robot, URDF, tables, meshes
  std::shared_ptr<const RobotModel> robot;
  double start_time = 0.0;      ///< time at the start [s]: 0, or the beginning of the planned motion
  double duration = 0.0;        ///< from start_time on [s]
  double control_period = 0.0;  ///< [s]
  JointVector start_position;   ///< [rad, m]
  /// Joint positions with which the tool is on its task, used if the gains have no joint_space_goal. Empty:
  /// the gains must have one.
  JointVector goal_position;
  JointVector start_velocity;  ///< velocity of the planned motion at start_time; empty: at rest
  /// Motion that the arm follows first. Null: the controller's first state is leaveSingularity.
  std::shared_ptr<const JointSpline> planned;
  Path path;                        ///< of the tool, base frame
  TaskMask mask = TaskMask::kPose;  ///< the part of path and gaze that the arm tracks
  /// True if there is nothing but a planned motion. The joints then stay at its last position, and the tool
  /// aims at nothing.
  bool holds_end = false;
  /// Distance from the last position of the planned motion within which joints count as settled [rad, m].
  double goal_tolerance = 0.005;
  std::vector<NamedPath> targets;  ///< of the gaze; empty: `orientation` gives the tool's orientation
  std::optional<ToolOrientation> orientation;
  double switch_every = 0.0;  ///< time between target switches [s]; 0: only those of `schedule`
  /// In order of time. Before the first entry, the gaze is at target 0. Empty: `switch_every` applies.
  std::vector<TargetTurn> schedule;
  std::optional<Camera> camera;  ///< none: the controller receives the true motion of the targets
  std::vector<MovingObstacle> obstacles;
  /// Measures the distances of the arm from itself and its cell. Null: the scenario has no cell.
  std::shared_ptr<const ClearanceModel> clearance;
  std::optional<Stimulus> stimulus;  ///< test signal that shifts the path or the target
  ThetaStart theta;
  PlantConditions plant;
  std::uint64_t seed = 1;  ///< of the noise
  double loop_gain = 1.0;  ///< factor on the loop's gains, to test a gain margin
  bool pushed = false;     ///< true: the scenario tests one stability margin and is judged by that alone

  int periods() const;
  /// Returns true if the arm begins a task of its tool before the scenario ends. It is false if a planned
  /// motion, which comes first, lasts to the end, or if there is nothing but a planned motion.
  bool has_task() const;
  /// Returns true if the joints stay at the end of a planned motion for at least one control period.
  bool holds_goal() const;
  /// Returns true if the active target changes during the scenario, including its first period.
  bool switches_target() const;
  /// Returns the index of the target that is active at t [s].
  std::size_t active_target(double t) const;
  /// Returns the time of the next target switch after t [s]; infinite if there is none.
  double next_switch(double t) const;
};

/// Reads a bundled scenario by name, or a file by path. If the file has `base: NAME` (or a list of names),
/// the top-level keys of these base files are read first. A key of the file itself then replaces the value of
/// the base file as a whole. Throws InputError.
Scenario load_scenario(const std::string& name_or_path);

/// Returns the gains that a rollout of the scenario uses. The gains that scale the feedback loop are
/// multiplied by loop_gain. If joint_space_goal is missing, goal_position replaces it. If goal_position is
/// missing too, start_position replaces it in a scenario with a planned motion. In any other scenario, this
/// throws InputError.
Gains with_goal(Gains gains, const Scenario& scenario);

/// Returns the model of the simulated arm: the robot's model, or `plant.arm`, with the factors of `plant`
/// applied, then payload and friction added.
RobotModel plant_model(const Scenario& scenario);

/// Returns the theta (13 n) with which the controller starts.
ParameterVector start_theta(const Scenario& scenario);

/// Replaces the scenario's start value of theta by the values of a file. Throws InputError if the file does
/// not fit the robot.
void start_theta_from(const std::string& file, Scenario& scenario);

}  // namespace armtune::internal
