#pragma once
// A UR10 under the complete controller without a simulator: gains, surroundings and an independent plant.

#include <memory>
#include <vector>

#include "core/control/laws/controller.hpp"

namespace armtune::internal::test {

/// Gains of the published UR10 controller's size, but with a leaveSingularity of 0.5 s.
Gains ur10_gains();

/// The surroundings and the arm of a controller under test. The path and the target are such that at the
/// joint space goal the tool stands on the path, at rest, and looks at the target.
struct Rig {
  Rig();

  std::shared_ptr<const RobotModel> model;
  Gains gains;
  double period = 0.002;
  Path path;
  Vec3 p_0G;
  std::vector<Obstacle> obstacles;

  /// The joint space goal, at rest.
  JointState goal() const;
  Scene scene() const { return {&path, {p_0G, Vec3::Zero(), Vec3::Zero()}, obstacles}; }
  std::unique_ptr<Controller> controller(const ParameterVector& theta) const;
  std::unique_ptr<Controller> controller() const;  ///< theta at the model

  /// A controller that, held at the goal, has left leaveSingularity and returned to the path by `time`.
  std::unique_ptr<Controller> following(double& time) const;
};

/// Obstacles beside the elbow and the wrist of a rig's arm at its goal.
std::vector<Obstacle> obstacles_near(const Rig& rig);

/// q'' = (M + D)^-1 (tau - h) under a held torque: classical Runge-Kutta with `substeps` per period.
void integrate(const Chain& chain, const JointVector& torque, double period, int substeps, JointState& state);

}  // namespace armtune::internal::test
