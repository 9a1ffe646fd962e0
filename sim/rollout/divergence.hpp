#pragma once
// Explains in words why a rollout (one simulated scenario) diverged: which joint diverged, and why. A cause
// is named only if it was computed from the scenario's numbers.

#include <string>

#include "core/control/control_output.hpp"
#include "sim/rollout/prepared_scenario.hpp"

namespace armtune::internal {

/// A joint that is faster than this multiple of its velocity limit counts as diverged. It will not recover.
inline constexpr double kDivergedRatio = 20.0;

/// Returns a clause about the first joint whose position q or velocity qd (n) [rad, m; rad/s, m/s] is not
/// finite, or that moves faster than kDivergedRatio times its velocity limit. The clause is empty if there is
/// no such joint.
std::string diverged_joint(const RobotModel& model, const JointVector& q, const JointVector& qd);

/// Returns the largest a for which v[k+1] = v[k] - a v[k-d] decays, where d is delay_periods. Here v[k] is a
/// velocity in period k, damped by a torque that is held for one period and delayed by d periods. The largest
/// a is 2 cos(d pi / (2 d + 1)) (Levin and May 1976).
double damping_limit(int delay_periods);

/// Returns a message that names a joint that the damping gain Kd (n) [N m s/rad, N s/m] makes unstable, and
/// suggests a remedy. The instability arises because the torque is constant over a control period. Returns an
/// empty text if Kd makes no joint unstable.
///
/// A joint is unstable if Kd h exceeds damping_limit() times J. Here h is the control period, and J is the
/// inertia that the joint moves if the other joints are free. The friction of the joint is taken into
/// account: it damps too, and the law may compensate it.
///
/// measured: the joint state of the last period.
std::string unstable_damping(const PreparedScenario& prepared, const JointState& measured,
                             const JointVector& Kd);

}  // namespace armtune::internal
