#pragma once
// What all kinds of plan have in common: the arm, its start, its limits, its distance from obstacles.

#include <vector>

#include "tuner/planning/tasks/plan_start.hpp"
#include "tuner/planning/transcription/trajectory_program.hpp"

namespace armtune::internal {

struct PlanCommon {
  PlanTask task;
  std::shared_ptr<const RobotModel> robot;  ///< as it really is in the scenario
  StartState start;
  std::optional<ControllerMotion> controller;  ///< where the task starts from a rollout

  int n() const { return robot->n(); }
  /// The joints with their limits.
  std::vector<Coordinate> coordinates() const;
  /// A program of these limits from this start; the task itself is still to be added.
  TrajectoryTask on(const TimeGrid& grid) const;
  /// Of the task's duration, or free from a guess [s] on.
  Phase phase(const char* name, int intervals, double guess) const;
  TimeGrid grid(std::vector<Phase> phases) const;
  /// The task's duration, else the controller's, else `otherwise` [s].
  double first_duration(double otherwise) const;
  /// What the slowest joint takes for its way (n) [rad, m] at half its velocity limit, at least 0.2 s.
  double likely_duration(const JointVector& way) const;
  /// What it takes to stop from the start's velocity, and as much again for the way back [s].
  double turning_time() const;
  /// Throws that the tool cannot be at a point [m].
  [[noreturn]] void no_pose(const Vec3& tool) const;
};

/// From rest to the velocity limit, where no limit says how long it takes [s].
inline constexpr double kAccelerationTime = 0.2;

}  // namespace armtune::internal
