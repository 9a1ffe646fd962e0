#pragma once
// Generates a first scenario for an arm from its URDF alone, for users to tune gains on and to edit. The tool
// follows a circle far from singular positions and joint limits, and its z axis (the gaze) aims alternately
// at two targets ahead of the tool.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

struct TaskOptions {
  /// Height of the floor above the base frame's origin, measured opposite to gravity [m]. Not used if `cell`
  /// is given. If neither is given, the floor is at the base (height 0) of an arm with an upright base, and
  /// any other arm has no floor.
  std::optional<double> floor;
  /// Cell around the arm, with or without a floor. If it is empty, the surroundings are the floor alone.
  std::optional<Cell> cell;
  bool without_floor = false;    ///< true: no floor, not even below an upright arm
  std::optional<TaskMask> mask;  ///< empty: position and gaze, or position alone if no such task is found
  bool thorough = false;  ///< tries ten times as many positions, for an arm that can hardly hold its weight
  /// Factor on the duration of one lap of the circle and on the time between target switches [1]. Meant for
  /// an arm that is too slow for the task.
  double slowness = 1.0;
};

/// Returns true if the task assumes a floor at the height of the base. This is so for an upright arm if the
/// options give no floor and no cell, and without_floor is false.
bool assumes_floor(const RobotModel& robot, const TaskOptions& options);

struct DefaultTask {
  Scenario scenario;
  JointVector goal;             ///< joint positions at the start of the path (n) [rad, m]
  double manipulability = 0.0;  ///< smallest value on the task
  bool in_given_cell = false;   ///< the cell was given in TaskOptions
  bool without_floor = false;   ///< as in TaskOptions
  double load = 0.0;            ///< largest holding torque of a joint, as a fraction of its effort limit
  int loaded = 0;               ///< index of the joint with that load
};

/// Returns a task that the arm can do. The circle is perpendicular to the tool's z axis. Its radius is 0.09
/// of the arm's reach, and is halved up to three times if no place for a larger circle is found. The search
/// prefers places far from singularities and joint limits, where the tool points down and little torque holds
/// the arm still.
///
/// On the whole circle:
///   - the tool and the joints from the third on stay at least 0.1 m above the floor,
///   - the tool stays clear of the arm,
///   - links whose shapes are known do not touch each other, and those from the third on stay at least 0.05 m
///     clear of the cell and the floor,
///   - the torque that holds the arm still is at most 0.85 of each joint's effort limit.
///
/// The simulation starts at joint positions off the circle. These are moved closer to the circle if holding
/// the arm still on the way to it takes too much torque. A torque is too much if it is more than half of a
/// joint's effort limit and a larger share of a limit than anywhere on the circle. At least 1/32 of the
/// original distance remains.
///
/// The arm tracks position and gaze. It tracks the position alone if it has too few joints for both, or if no
/// place for both is found. The plant has noise, a delay of one period and a payload of two per cent of the
/// arm's mass, and the controller starts with masses that are too low. High gains therefore have
/// disadvantages too. Throws InputError with the reason if no place is found. An arm is refused without a
/// search if it can hold itself, with 0.85 of each effort limit, at less than 5 % of its joint positions.
DefaultTask default_task(std::shared_ptr<const RobotModel> robot, const TaskOptions& options = {});

/// Returns up to `count` (>= 1) tasks, the preferred ones first. The first is the task of default_task. The
/// others are at other places, or are smaller circles at the same places. Throws InputError if there is no
/// task.
std::vector<DefaultTask> default_tasks(std::shared_ptr<const RobotModel> robot, const TaskOptions& options,
                                       std::size_t count);

}  // namespace armtune::internal
