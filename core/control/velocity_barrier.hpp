#pragma once
// A velocity barrier damps a joint, and damps it more as |q'| approaches the joint's limit. It acts against
// torques that bypass the velocity reference, such as the repulsion of obstacles:
//   tau_i <- tau_i - gain * Kd_i * h * (|q'_i| - start * limit_i) * sign(q'_i),
//   h = 3 x^2 - 2 x^3,   x = (|q'_i| / limit_i - start) / (1 - start).
// start is a fraction of the limit. h rises from 0 at |q'_i| = start * limit_i, where the barrier begins, to
// 1 at the limit. In addition, the barrier multiplies a bypassing torque in the direction of motion by 1 - h.
// The damping acts only on the part of |q'_i| above start * limit_i. The slope of this torque therefore stays
// below 1.7 * gain * Kd. With a steeper slope, the sampled control loop would oscillate.

#include <algorithm>
#include <cmath>

#include "core/common/types.hpp"

namespace armtune::internal {

/// Returns h in [0, 1] at a joint velocity. start: share of the limit where the barrier begins, in [0, 1).
inline double velocity_barrier(double qd, double limit, double start) {
  const double x = std::clamp((std::abs(qd) / limit - start) / (1.0 - start), 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

/// Adds to the torque the barrier's damping and `bypassing` (n), a torque that does not come from the
/// reference. qd (n): measured; limits (n) > 0; Kd (n) [N m s/rad]. With gain 0, `bypassing` is added
/// unchanged.
inline void add_behind_barrier(const JointVector& qd, const JointVector& limits, double start, double gain,
                               const JointVector& Kd, const JointVector& bypassing, JointVector& torque) {
  for (Eigen::Index i = 0; i < torque.size(); ++i) {
    const double h = gain > 0.0 ? velocity_barrier(qd[i], limits[i], start) : 0.0;
    const bool pushes_on = bypassing[i] * qd[i] > 0.0;
    const double room = start * limits[i];
    const double beyond = qd[i] - std::clamp(qd[i], -room, room);
    torque[i] += (pushes_on ? 1.0 - h : 1.0) * bypassing[i] - gain * h * Kd[i] * beyond;
  }
}

}  // namespace armtune::internal
