#pragma once
// A scenario: the robot, the tool's path, the gaze targets with their schedule, the obstacles, and the
// differences between the real arm and the controller's model of it.

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
  double position_noise = 0.0;   ///< standard deviation, white, per period [rad, m]
  double velocity_noise = 0.0;   ///< [rad/s, m/s]
  int torque_delay_periods = 0;  ///< whole control periods
  Payload payload;               ///< at the tool, unknown to the controller
  JointVector viscous_friction;  ///< added to the model's, unknown to the controller; n or empty
  JointVector coulomb_friction;
  JointVector mass_factors;     ///< factor on each link's mass, first moment and inertia; n or empty (all 1)
  JointVector inertia_factors;  ///< also on its inertia about the centre of mass alone; n or empty (all 1)
  Eigen::Matrix3Xd center_offsets;  ///< of each link's centre of mass, link frame [m]; 3 x n or empty (all 0)
  JointVector rotor_factors;        ///< factor on each joint's rotor inertia; n or empty (all 1)
};

/// The camera that measures the positions of the gaze targets. The controller estimates their motion from
/// these noisy positions.
struct Camera {
  double noise = 0.0;       ///< standard deviation of each coordinate, white, per period [m]
  double bandwidth = 15.0;  ///< of the filter that estimates position, velocity, acceleration [rad/s]
};

/// The name that result files use for all scenarios together. No scenario may have it.
inline constexpr const char* kAllScenarios = "all";

struct Scenario {
  std::string name;
  std::string description;
  std::string source;               ///< file
  std::vector<std::string> inputs;  ///< every file it was read from: bases, robot, URDF
  std::shared_ptr<const RobotModel> robot;
  double start_time = 0.0;      ///< time at the start [s]: 0, or the beginning of the planned motion
  double duration = 0.0;        ///< from start_time on [s]
  double control_period = 0.0;  ///< [s]
  JointVector start_position;   ///< [rad, m]
  JointVector goal_position;    ///< on the task; replaces a missing joint_space_goal; empty: gains need one
  JointVector start_velocity;   ///< velocity of the planned motion at start_time; empty: at rest
  std::shared_ptr<const JointSpline> planned;  ///< followed first; null: the first state is leaveSingularity
  Path path;                                   ///< of the tool, base frame
  TaskMask mask = TaskMask::kPose;             ///< the part of path and gaze that the arm tracks
  bool holds_end = false;  ///< the task is to stay where the planned motion ended, and aims at nothing
  std::vector<NamedPath> targets;  ///< of the gaze; empty: `orientation` gives the tool's orientation
  std::optional<ToolOrientation> orientation;
  double switch_every = 0.0;         ///< time between target switches [s]; 0: only those of `schedule`
  std::vector<TargetTurn> schedule;  ///< in order of time; begins at target 0; empty: `switch_every` applies
  std::optional<Camera> camera;      ///< none: the controller receives the true motion of the targets
  std::vector<MovingObstacle> obstacles;
  std::shared_ptr<const ClearanceModel> clearance;  ///< of the arm from itself and its cell; null: no cell
  std::optional<Stimulus> stimulus;                 ///< test signal that shifts the path or the target
  ThetaStart theta;
  PlantConditions plant;
  std::uint64_t seed = 1;  ///< of the noise
  double loop_gain = 1.0;  ///< factor on the loop's gains, to test a gain margin
  bool pushed = false;     ///< the scenario tests a stability margin, and only that margin is judged in it

  int periods() const;
  /// Returns true if the arm begins the task before the scenario ends. It is false if a planned motion, which
  /// comes first, lasts to the end.
  bool has_task() const;
  /// Returns true if the active target changes during the scenario, its first period included.
  bool switches_target() const;
  /// Returns the index of the target that is active at t [s].
  std::size_t active_target(double t) const;
  /// Returns the time of the next target switch after t [s]; infinite if there is none.
  double next_switch(double t) const;
};

/// Reads a bundled scenario by name, or a file by path. With `base: NAME` (or a list) in a file, the
/// top-level keys of these other files are read first. A key of the file itself then replaces the value of
/// the base as a whole. Throws InputError.
Scenario load_scenario(const std::string& name_or_path);

/// Returns the gains that a rollout of the scenario uses. The gains that scale the feedback loop are
/// multiplied by loop_gain. If joint_space_goal is missing, goal_position replaces it. If that is missing
/// too, start_position does in a scenario with a planned motion; in others, InputError is thrown.
Gains with_goal(Gains gains, const Scenario& scenario);

/// Returns the model of the simulated arm: the robot's model with the factors of `plant` applied, then
/// payload and friction added.
RobotModel plant_model(const Scenario& scenario);

/// Returns the theta (13 n) with which the controller starts.
ParameterVector start_theta(const Scenario& scenario);

/// Replaces the scenario's start value of theta by the values of a file. Throws InputError if the file does
/// not fit the robot.
void start_theta_from(const std::string& file, Scenario& scenario);

}  // namespace armtune::internal
