#pragma once
// Impedance obstacle avoidance (equations 9 and 10):
//   tau = sum_i J_i^T k_f,i sum_j f(i,j),   f = (1 - |d|/r_o)^2 d/|d|,   d = joint origin i - centre of j.

#include <span>

#include "core/robot/kinematics.hpp"

namespace armtune {

/// Repulsion of one obstacle on one point, at most 1 long; zero from r_o on.
Vec3 repulsion(const Vec3& d, double influence_radius);

/// Smallest distance of any joint origin to any centre [m]; infinite without obstacles.
double obstacle_distance(const Poses& poses, std::span<const Vec3> centers);

/// Repulsive joint torques (n) [N m]. Those of the fourth joint and up are zero, as published: the wrist
/// belongs to the gaze.
void obstacle_torque(const Chain& chain, const Poses& poses, std::span<const Vec3> centers,
                     double influence_radius, const JointVector& force_gains, JointVector& tau);

}  // namespace armtune
