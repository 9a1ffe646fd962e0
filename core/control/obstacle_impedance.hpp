#pragma once
// Computes the joint torques by which the arm avoids obstacles (equations 9 and 10 in NOTATION.md). Every
// obstacle j repels the origin of every joint i with a force f(i,j). The joint torques are
//   tau = sum_i k_f,i * (J_i^T sum_j f(i,j)),   f(i,j) = (1 - s/r_o)^2 d/|d|.
// Here d is the vector from the centre of obstacle j to the origin of joint i, and s = |d| - radius of j is
// the distance. r_o is the influence radius; f is zero at larger distances. J_i is the Jacobian of the origin
// of joint i. The gain k_f,i is one number, or has one value for each entry of the torque (force_gains.hpp).
//
// If the chain has link_radius, the forces act on the links instead. d then ends at the point of link i that
// is nearest to the centre, s is measured to the link's surface, and J_i is the Jacobian of that point.

#include <span>

#include "core/control/force_gains.hpp"
#include "core/control/obstacle.hpp"
#include "core/robot/kinematics.hpp"

namespace armtune::internal {

/// Returns the repulsion f of one obstacle. d [m]: from the obstacle's centre to the point on the arm. inside
/// [m]: part of |d| that lies inside the obstacle or the link. The length of f is at most 1. It is zero if
/// |d| - inside is influence_radius or more.
Vec3 repulsion(const Vec3& d, double influence_radius, double inside = 0.0);

/// Computes the repulsive joint torques (n) [N m]. As published, the torques of the fourth joint and of all
/// joints after it are zero, because the wrist has to point the tool at its target.
void obstacle_torque(const Chain& chain, const Poses& poses, std::span<const Obstacle> obstacles,
                     double influence_radius, const ForceGains& force_gains, JointVector& tau);

}  // namespace armtune::internal
