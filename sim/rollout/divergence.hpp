#pragma once
// Explains in words why a rollout diverged: in which joint the divergence shows, and its cause. A cause is
// named only if it was computed from the scenario's numbers.

#include <string>

#include "core/control/control_output.hpp"
#include "sim/rollout/prepared_scenario.hpp"

namespace armtune::internal {

/// The multiple of its velocity limit beyond which a joint will not recover.
inline constexpr double kDivergedRatio = 20.0;

/// Returns a clause on the first joint whose position q or velocity qd (n) [rad, m; /s] is not finite, or
/// that moves faster than kDivergedRatio times its velocity limit. It is empty if there is no such joint.
std::string diverged_joint(const RobotModel& model, const JointVector& q, const JointVector& qd);

/// Returns the largest a for which v <- v - a v(d periods ago) decays, 2 cos(d pi / (2 d + 1)). There v is a
/// velocity that is damped by a held and delayed torque (Levin and May 1976).
double damping_limit(int delay_periods);

/// Returns a message that names the joint that the damping Kd (n) [N m s/rad, N s/m] makes unstable, and what
/// to do about it. The cause is that the torque is held over a control period. Empty if Kd makes no joint
/// unstable.
/// A joint is unstable if Kd h (h: control period) exceeds damping_limit() times the inertia that it moves
/// with the other joints free. The friction of the joint is taken into account: it damps too, and the law may
/// compensate it.
/// measured: the joint state of the last period.
std::string unstable_damping(const PreparedScenario& prepared, const JointState& measured,
                             const JointVector& Kd);

}  // namespace armtune::internal
