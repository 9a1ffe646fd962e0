#pragma once
// A task for `armtune plan`, read from a YAML file. It defines which motion is planned, in which scenario,
// and under which limits.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// The kinds of planning tasks. The gaze is the direction of the tool's z axis, which some tasks point at a
/// target.
enum class PlanKind {
  kMove,     ///< from one joint position to another
  kTrack,    ///< along the scenario's tool path with the gaze at its targets, with the least error
  kSwitch,   ///< the gaze moves to the next target while the tool stays on its path
  kReturn,   ///< the tool moves back to its path and arrives with the path's velocity and acceleration
  kFastest,  ///< along the tool path's curve in the least time
};

/// Returns every kind with its name in task files.
const std::vector<std::pair<PlanKind, std::string>>& plan_kinds();
std::string name(PlanKind kind);

struct PlanLimits {
  double velocity = 1.0;     ///< share of the robot's velocity limits
  double effort = 1.0;       ///< share of its effort limits
  JointVector acceleration;  ///< n, or empty: only the robot's limits [rad/s^2, m/s^2]
  JointVector jerk;          ///< n, or empty: no limit [rad/s^3, m/s^3]
};

/// The start of the motion. If nothing is given, a task of the kind kMove starts at the scenario's start
/// position. Tasks of the other kinds then start with the tool on its path and the gaze at the target.
struct PlanStart {
  JointVector position;      ///< n or empty
  JointVector velocity;      ///< n or empty (at rest)
  JointVector acceleration;  ///< n or empty (free; 0 at rest under a jerk limit)
  std::string rollout;       ///< CSV file of a rollout, whose row at the plan's start is used
};

struct PlanTask {
  std::string name;
  std::string description;
  std::string source;  ///< path of the task's file
  PlanKind kind = PlanKind::kMove;
  Scenario scenario;  ///< gives the true robot (payload, friction), path, targets, obstacles
  double at = 0.0;    ///< start of the plan in the scenario's time [s]
  PlanStart start;
  JointVector goal;                ///< kMove: n
  std::optional<double> duration;  ///< fixed duration [s]; none: the least possible is found
  double hold = 0.5;               ///< kSwitch: the gaze stays on target this long [s]
  bool least_error = false;        ///< kSwitch: least gaze error over a fixed duration in place of least time
  double path_tolerance = 1e-3;    ///< largest tool error along x, y, z [m]
  double gaze_threshold = 0.15;    ///< largest gaze angle that counts as on target [rad]
  bool end_gaze = false;           ///< kReturn: true if the gaze must be within its threshold at the end
  double clearance = 0.0;          ///< least distance of joint origins and tool from obstacles' surfaces, and
                                   ///< of links from the cell [m]; 0: none. Links keep the same distance from
                                   ///< each other, but at most 5 mm
  PlanLimits limits;
  int knots = 200;           ///< number of intervals of the time grid
  double smoothness = 1e-9;  ///< small weight of jerk in the cost; selects one of many equal optima
};

/// Reads a bundled task by name, or a file by path. Throws InputError.
PlanTask load_plan_task(const std::string& name_or_path);

/// Returns the acceleration limits (n) of the plan [rad/s^2, m/s^2]: for each joint, the smaller limit of
/// task and robot, or infinity if it has neither.
JointVector acceleration_limits(const PlanTask& task);

/// Returns the text of the task with every default written out.
std::string plan_task_yaml(const PlanTask& task);

}  // namespace armtune::internal
