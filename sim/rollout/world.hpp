#pragma once
// Computes the surroundings of the arm in one control period: gaze target (the point at which the tool's z
// axis aims), point on the tool's path, and obstacles. They depend only on time, not on the arm's motion.

#include <optional>
#include <vector>

#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

struct World {
  double time = 0.0;                ///< [s]
  std::size_t target = 0;           ///< index of the active target
  MotionPoint<Vec3> target_motion;  ///< of the active target, stimulus included; NaN without targets
  std::optional<OrientationPoint> orientation;  ///< desired orientation; none: the tool has a gaze target
  MotionPoint<Vec3> on_path;                    ///< of the tool's path, stimulus included
  Vec3 path_shift = Vec3::Zero();               ///< shift of the path by the stimulus [m]
  std::vector<Obstacle> obstacles;
};

/// Computes the world of the scenario's k-th period. Allocates nothing from the second call on.
void world_at(const Scenario& scenario, int k, World& world);

}  // namespace armtune::internal
