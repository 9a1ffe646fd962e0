#pragma once
// A scenario: the robot, the tool's path, gaze targets with their schedule, obstacles, and how the real arm
// differs from what the controller knows.

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

/// From `at` [s] on the gaze is at a target.
struct TargetTurn {
  double at = 0.0;
  std::size_t target = 0;  ///< index
};

/// What theta starts from: scale * the controller's model (0: nothing known, 1: the model), or given values.
struct ThetaStart {
  double model_scale = 0.0;
  std::string file;         ///< theta by name in YAML, with its values in `given`; empty: model_scale counts
  JointVector factors;      ///< then on each link's and its joint's parameters; n or empty (all 1)
  ParameterVector given{};  ///< 13 n, or empty
};

/// How the plant differs from the controller's model, and what lies between them.
struct PlantConditions {
  double position_noise = 0.0;   ///< standard deviation, white, per period [rad, m]
  double velocity_noise = 0.0;   ///< [rad/s, m/s]
  int torque_delay_periods = 0;  ///< whole control periods
  Payload payload;               ///< at the tool, unknown to the controller
  JointVector viscous_friction;  ///< unknown to the controller, on top of the model's; n or empty
  JointVector coulomb_friction;
  JointVector mass_factors;     ///< on each link's mass, first moment and inertia alike; n or empty (all 1)
  JointVector inertia_factors;  ///< then on its inertia about the centre of mass; n or empty
  Eigen::Matrix3Xd center_offsets;  ///< of each link's centre of mass, link frame [m]; 3 x n or empty (all 0)
  JointVector rotor_factors;        ///< on each joint's rotor inertia; n or empty
};

/// How the controller sees the targets when it does not know their motion.
struct Camera {
  double noise = 0.0;       ///< standard deviation of each coordinate, white, per period [m]
  double bandwidth = 15.0;  ///< of the filter that estimates position, velocity, acceleration [rad/s]
};

struct Scenario {
  std::string name;
  std::string description;
  std::string source;               ///< file
  std::vector<std::string> inputs;  ///< every file it was read from: bases, robot, URDF
  std::shared_ptr<const RobotModel> robot;
  double start_time = 0.0;      ///< what the clock begins with [s]: 0, or the planned motion's beginning
  double duration = 0.0;        ///< from then on [s]
  double control_period = 0.0;  ///< [s]
  JointVector start_position;   ///< [rad, m]
  JointVector goal_position;    ///< on the task, of leaveSingularity where gains have none; empty: they must
  JointVector start_velocity;   ///< the planned motion's; empty: at rest
  std::shared_ptr<const JointSpline> planned;  ///< what the controller follows first; null: leaveSingularity
  Path path;                                   ///< of the tool, base frame
  TaskMask mask = TaskMask::kPose;             ///< which part of path and gaze the arm is to hold
  bool holds_end = false;  ///< the task is to stay where the planned motion ended, and aims at nothing
  std::vector<NamedPath> targets;  ///< of the gaze; empty: `orientation` says how the tool is turned
  std::optional<ToolOrientation> orientation;
  double switch_every = 0.0;         ///< targets take turns [s]; 0: always the first, or as `schedule` says
  std::vector<TargetTurn> schedule;  ///< rising; the first target before it; empty: `switch_every` counts
  std::optional<Camera> camera;      ///< none: the controller knows the targets' motion
  std::vector<MovingObstacle> obstacles;
  std::shared_ptr<const ClearanceModel> clearance;  ///< of the arm from itself and its cell; null: no cell
  std::optional<Stimulus> stimulus;                 ///< added to path or target, unknown to the controller
  ThetaStart theta;
  PlantConditions plant;
  std::uint64_t seed = 1;  ///< of the noise
  double loop_gain = 1.0;  ///< factor on the gains of the loop, as a gain margin pushes it
  bool pushed = false;     ///< a margin pushes the scenario: it is judged by that margin alone

  int periods() const;
  /// Whether the controller comes to its own task: not where a planned motion lasts to the end.
  bool has_task() const;
  /// Whether the targets take turns in the course of it, its first period included.
  bool switches_target() const;
  /// Index of the target that is active at t [s].
  std::size_t active_target(double t) const;
  /// When another target's turn comes after t [s]; infinite if none does.
  double next_switch(double t) const;
};

/// Reads a bundled scenario by name, or a file by path. `base: NAME` (or a list) takes every top-level key
/// from other files first; the file's own keys replace them whole. Throws InputError.
Scenario load_scenario(const std::string& name_or_path);

/// Returns the gains as a rollout of the scenario uses them: the loop's multiplied by its loop_gain, and
/// joint_space_goal the scenario's where they have none. Throws InputError if neither has one.
Gains with_goal(Gains gains, const Scenario& scenario);

/// The arm as it really is in the scenario: factors, then payload and friction included.
RobotModel plant_model(const Scenario& scenario);

/// theta (13 n) that the controller starts from.
ParameterVector start_theta(const Scenario& scenario);

/// Lets theta start from a file, in place of what the scenario says. Throws InputError if it does not fit the
/// robot.
void start_theta_from(const std::string& file, Scenario& scenario);

}  // namespace armtune::internal
