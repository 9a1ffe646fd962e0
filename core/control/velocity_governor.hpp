#pragma once
// The velocity governor. It slows the joint reference as a whole, so that the reference keeps its direction,
// until every |qr'| is below its bound:
//   qr'  <- sigma qr',   qr'' <- sigma^2 qr'' + sigma' qr',   sigma = f(r) / r,
// where r is the p-norm of qr'_i / bound_i, which is never less than the largest of them. f(r) = r up to the
// knee k, and k + (1 - k) tanh((r - k) / (1 - k)) < 1 beyond it. f is twice continuously differentiable, so
// nothing chatters at the edge. sigma^2 scales the acceleration of a motion whose time runs at rate sigma.

#include "core/control/joint_space_law.hpp"
#include "core/control/task_inverse.hpp"

namespace armtune::internal {

/// Share of the bound up to which the reference is left unchanged.
inline constexpr double kGovernorKnee = 0.8;

/// Slows the reference in place. bound (n): share of the velocity limits [rad/s, m/s], > 0. Returns sigma, in
/// (0, 1], the rate at which the time of interpolations may run.
double govern(const JointVector& bound, JointReference& reference);

/// Shortest time in which an interpolation takes a joint from rest to its bound [s]. Arms whose inertia
/// differs from the model's overshoot faster ones.
inline constexpr double kRampTime = 0.1;

/// Returns the time [s] that a rest-to-rest quintic over a displacement (linear [m], rotation vector [rad])
/// needs so that no joint exceeds its bound (n) in velocity, or bound / kRampTime in acceleration, with the
/// present Jacobian. The peaks of a quintic over the way w in the time T are 15/8 w/T and 10/sqrt(3) w/T^2.
double shortest_duration(const TaskInverse& inverse, const Vec6& displacement, const JointVector& bound);

}  // namespace armtune::internal
