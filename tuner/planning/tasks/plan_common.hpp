#pragma once
// The inputs that all kinds of planning tasks share: the arm, its start state, its limits and its distance
// from obstacles. The optimisation problem of each kind of task is built on them.

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
  /// Returns a phase with the task's duration. If the task has none, the phase is free, and `guess` is the
  /// first guess of its duration [s].
  Phase phase(const char* name, int intervals, double guess) const;
  TimeGrid grid(std::vector<Phase> phases) const;
  /// Returns the task's duration, else the time that the controller took, else `otherwise` [s].
  double first_duration(double otherwise) const;
  /// Returns the time [s] in which every joint can make its displacement at half its velocity limit; at least
  /// 0.2 s. way: displacement of each joint (n) [rad, m].
  double likely_duration(const JointVector& way) const;
  /// Returns twice the time to stop from the start's velocity [s]: for stopping and for moving back.
  double turning_time() const;
  /// Throws OutOfReach with the message that no joint position puts the tool at this point [m].
  [[noreturn]] void no_pose(const Vec3& tool) const;
};

/// Assumed time from rest to the velocity limit [s]. An acceleration limit can make this time longer.
inline constexpr double kAccelerationTime = 0.2;

}  // namespace armtune::internal
