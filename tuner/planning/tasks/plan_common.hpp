#pragma once
// Holds the inputs that all kinds of planning tasks share: the arm, its start state, its limits and its
// distance from obstacles. The optimisation problem of each kind of task is built on these inputs.

#include <vector>

#include "tuner/planning/tasks/plan_start.hpp"
#include "tuner/planning/transcription/trajectory_program.hpp"

namespace armtune::internal {

struct PlanCommon {
  PlanTask task;
  std::shared_ptr<const RobotModel> robot;  ///< the scenario's true arm (payload, friction)
  StartState start;
  std::optional<ControllerMotion> controller;  ///< set if the task starts from a rollout

  int n() const { return robot->n(); }
  /// Returns the joints with their limits.
  std::vector<Coordinate> coordinates() const;
  /// Returns an optimisation problem with these limits and this start state. The caller adds the goals of the
  /// task.
  TrajectoryTask on(const TimeGrid& grid) const;
  /// Returns a phase (a section of the time grid) with the task's duration. If the task gives no duration,
  /// the duration is free, and `guess` is its first guess [s].
  Phase phase(const char* name, int intervals, double guess) const;
  TimeGrid grid(std::vector<Phase> phases) const;
  /// Returns the task's duration [s]. If it has none, returns the time that the controller took, and if that
  /// is unknown, `otherwise`.
  double first_duration(double otherwise) const;
  /// Returns the time [s] in which every joint can make its displacement at half its velocity limit; at least
  /// 0.2 s. way: displacement of each joint (n) [rad, m].
  double likely_duration(const JointVector& way) const;
  /// Returns twice the time that the arm needs to stop from its velocity at the start [s]: once for stopping,
  /// and once for moving back.
  double turning_time() const;
  /// Throws OutOfReach. The message says that no joint position puts the tool at this point [m].
  [[noreturn]] void no_pose(const Vec3& tool) const;
};

/// Assumed time from rest to the velocity limit [s], unless an acceleration limit makes it longer.
inline constexpr double kAccelerationTime = 0.2;

}  // namespace armtune::internal
