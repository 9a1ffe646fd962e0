#pragma once
// Obstacle avoidance by repulsive forces on the arm, which become joint torques (equations 9 and 10 in
// NOTATION.md):
//   tau = sum_i k_f,i * (J_i^T sum_j f(i,j)),   f = (1 - s/r_o)^2 d/|d|,   d = joint origin i - centre of j,
// with the obstacles j and s = |d| - radius of j. k_f,i multiplies joint by joint, or is one number
// (force_gains.hpp). In a chain with link_radius the forces act on the links instead. d then runs to the
// point of link i that is nearest to the centre, s is measured to the link's surface, and J_i is that of the
// point.

#include <span>

#include "core/control/force_gains.hpp"
#include "core/control/obstacle.hpp"
#include "core/robot/kinematics.hpp"

namespace armtune::internal {

/// Returns the repulsion f of one obstacle. d [m]: from the obstacle's centre to the point on the arm. inside
/// [m]: part of |d| that lies inside the obstacle or the link. f is at most 1 long, and zero if the remaining
/// distance is influence_radius or more.
Vec3 repulsion(const Vec3& d, double influence_radius, double inside = 0.0);

/// Computes the repulsive joint torques (n) [N m]. Those of the fourth joint and up are zero, as published,
/// since the wrist serves the gaze.
void obstacle_torque(const Chain& chain, const Poses& poses, std::span<const Obstacle> obstacles,
                     double influence_radius, const ForceGains& force_gains, JointVector& tau);

}  // namespace armtune::internal
