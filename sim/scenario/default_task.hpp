#pragma once
// Generates a first scenario for an arm from its URDF alone. The tool follows a circle at a place where the
// arm moves well, and aims at two targets ahead of it in turn. Users tune on it and edit it.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

struct TaskOptions {
  /// Height of the floor above the base frame's origin, against gravity [m]. None: an arm with an upright
  /// base stands on the floor, and any other arm has no floor.
  std::optional<double> floor;
  /// Cell around the arm. With a cell, the floor is that of the cell, or there is none. None: there is at
  /// most the floor.
  std::optional<Cell> cell;
  bool without_floor = false;    ///< no floor, not even below an upright arm
  std::optional<TaskMask> mask;  ///< none: position and gaze, or position alone where that does not fit
  bool thorough = false;  ///< tries ten times as many positions: for an arm that can hardly hold itself
  /// Factor on the duration of one lap of the circle and on the time between target switches [1]. Meant for
  /// an arm that is too slow for the task.
  double slowness = 1.0;
};

/// Returns true if the task assumes a floor that the options do not give: at the height of the base, under an
/// upright arm.
bool assumes_floor(const RobotModel& robot, const TaskOptions& options);

struct DefaultTask {
  Scenario scenario;
  JointVector goal;             ///< joint positions at the start of the path (n) [rad, m]
  double manipulability = 0.0;  ///< smallest value on the task
  bool in_given_cell = false;   ///< the cell was given in TaskOptions
  bool without_floor = false;   ///< as in TaskOptions
  double load = 0.0;            ///< largest fraction of an effort limit that holding the arm still takes
  int loaded = 0;               ///< index of the joint with that load
};

/// Returns a task that the arm can do. The circle is perpendicular to the tool's z axis. Its radius is 0.09
/// of the arm's reach, or down to an eighth of that where the arm's limits require it. Places are preferred
/// where the arm moves well, the tool looks down and the load is light.
///
/// On the whole circle:
///   - the tool and the joints from the third on stay 0.1 m above the floor,
///   - the tool stays clear of the arm,
///   - links whose shapes are known do not touch each other, and from the third on stay 0.05 m clear of the
///     cell,
///   - holding the arm still takes at most 0.85 of each effort limit.
///
/// The start position of the simulation is off the circle. It is moved closer to it if holding the arm on the
/// way takes more than on the circle and more than half of an effort limit. It keeps at least 1/32 of its
/// distance. The arm tracks position and gaze. It tracks the position alone if it has too few joints for more
/// or if no place for more is found. The plant has noise, a delay of one period and a payload of two per cent
/// of the arm's mass. The controller starts with masses that are too low, so that high gains have a price.
/// Throws InputError with the reason if no place is found.
DefaultTask default_task(std::shared_ptr<const RobotModel> robot, const TaskOptions& options = {});

/// Returns the task of default_task and up to `count` - 1 (count >= 1) others, the preferred ones first. They
/// are at other places, or smaller at the same places. Throws InputError if there is none.
std::vector<DefaultTask> default_tasks(std::shared_ptr<const RobotModel> robot, const TaskOptions& options,
                                       std::size_t count);

}  // namespace armtune::internal
