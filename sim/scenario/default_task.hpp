#pragma once
// A first task for an arm, made from its URDF alone: a circle where it moves well, and two targets ahead of
// the tool that take turns. It is something to begin tuning on, and to edit.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

struct TaskOptions {
  /// Height of the floor above the base frame's origin, against gravity [m]. None: the floor is where an arm
  /// stands whose base is upright, and there is none below any other.
  std::optional<double> floor;
  /// What stands around the arm; without it there is the floor alone. With it, its floor counts or there is
  /// none.
  std::optional<Cell> cell;
  bool without_floor = false;    ///< there is none, also below an arm that is upright
  std::optional<TaskMask> mask;  ///< none: position and gaze, or position alone where that does not fit
  bool thorough = false;  ///< looks at ten times as many positions: for an arm that can hardly hold itself
  /// Factor on the times of a turn and of a look, for an arm that is too slow for the task [1].
  double slowness = 1.0;
};

/// Whether the task stays above a floor that nobody gave: the base's height, under an arm that is upright.
bool assumes_floor(const RobotModel& robot, const TaskOptions& options);

struct DefaultTask {
  Scenario scenario;
  JointVector goal;             ///< (n) [rad, m] on the task where it begins
  double manipulability = 0.0;  ///< the smallest on the task
  bool in_given_cell = false;   ///< the cell is one that was given, not the floor alone
  bool without_floor = false;   ///< as TaskOptions has it
  double load = 0.0;            ///< largest share of a joint's effort limit that holding the arm still takes
  int loaded = 0;               ///< the joint whose load that is
};

/// Returns a task that the arm can do. The circle's radius is a tenth of the arm's reach, or less where its
/// limits ask for that, and it is perpendicular to the tool's z axis. Places where the arm moves well and the
/// tool looks down, lightly loaded, come first. On the whole circle, the tool and the joints from the third
/// on stay 0.1 m above the floor, the tool stays clear of the arm, links whose shapes are known do not touch
/// each other and stay 0.05 m clear of the cell, and holding the arm still takes at most 0.85 of each effort
/// limit. The start is brought closer where the way from it would take more than the task and more than half
/// of a limit, to a 32nd of its distance at most. The task is position and gaze, or position alone where the
/// arm has no joints or no place for more. The plant has noise, a period of delay, a payload of two per cent
/// of the arm's mass, and the controller takes the arm for lighter than it is, so that high gains have a
/// price. Throws InputError that says why there is no such place.
DefaultTask default_task(std::shared_ptr<const RobotModel> robot, const TaskOptions& options = {});

/// That task, and others at other places or smaller at one of them, up to `count` (>= 1): those to be
/// preferred first.
std::vector<DefaultTask> default_tasks(std::shared_ptr<const RobotModel> robot, const TaskOptions& options,
                                       std::size_t count);

}  // namespace armtune::internal
