#pragma once
// Impedance obstacle avoidance (equations 9 and 10):
//   tau = sum_i k_f,i * (J_i^T sum_j f(i,j)),   f = (1 - s/r_o)^2 d/|d|,   d = joint origin i - centre of j,
// s = |d| - radius of j. k_f,i multiplies joint by joint, or is one number (force_gains.hpp). A chain with
// link_radius keeps its links away instead: d runs to the point of link i that is nearest to the centre, s
// ends at the link's surface, and J_i is that point's.

#include <span>

#include "core/control/force_gains.hpp"
#include "core/control/obstacle.hpp"
#include "core/robot/kinematics.hpp"

namespace armtune::internal {

/// Repulsion by a surface `inside` [m] short of d, at most 1 long; zero from r_o on before the surface.
Vec3 repulsion(const Vec3& d, double influence_radius, double inside = 0.0);

/// Repulsive joint torques (n) [N m]. Those of the fourth joint and up are zero, as published: the wrist
/// belongs to the gaze.
void obstacle_torque(const Chain& chain, const Poses& poses, std::span<const Obstacle> obstacles,
                     double influence_radius, const ForceGains& force_gains, JointVector& tau);

}  // namespace armtune::internal
