#pragma once
// The velocity governor slows the joint reference until every |qr'| is below its bound. All joints are slowed
// by the same factor, so the reference keeps its direction:
//   qr'  <- sigma qr',   qr'' <- sigma^2 qr'' + sigma' qr',   sigma = f(r) / r,
// where r is the p-norm of the ratios qr'_i / bound_i, which is at least the largest |qr'_i| / bound_i.
// f(r) = r up to the knee k, and k + (1 - k) tanh((r - k) / (1 - k)) < 1 beyond it. f is twice continuously
// differentiable, so that the reference does not chatter at the knee. The factor sigma^2 arises because the
// time of the motion runs at the rate sigma.

#include "core/control/joint_space_law.hpp"
#include "core/control/task_inverse.hpp"

namespace armtune::internal {

/// Share of the bound up to which the reference is left unchanged.
inline constexpr double kGovernorKnee = 0.8;

/// Slows the reference in place. bound (n): share of the velocity limits [rad/s, m/s], > 0. Returns sigma, in
/// (0, 1], the rate at which the time of interpolations may run.
double govern(const JointVector& bound, JointReference& reference);

/// Shortest time in which an interpolation may accelerate a joint from rest to its velocity bound [s]. With a
/// shorter time, arms whose inertia differs from the model's would overshoot.
inline constexpr double kRampTime = 0.1;

/// Returns the shortest time [s] in which a rest-to-rest quintic may move the tool over a displacement
/// (linear [m], rotation vector [rad]). At the present Jacobian, no joint then exceeds its bound (n) in
/// velocity, or bound / kRampTime in acceleration. For a distance w and a time T, the largest velocity of a
/// quintic is 15/8 w/T, and its largest acceleration is 10/sqrt(3) w/T^2.
double shortest_duration(const TaskInverse& inverse, const Vec6& displacement, const JointVector& bound);

}  // namespace armtune::internal
