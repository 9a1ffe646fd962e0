#include "core/control/obstacle_impedance.hpp"

#include <algorithm>
#include <cmath>

namespace armtune {

Vec3 repulsion(const Vec3& d, double influence_radius) {
  const double distance = d.norm();
  if (!(distance < influence_radius)) return Vec3::Zero();
  // At the centre itself no direction is better than another; the base's z keeps the torque finite.
  if (!(distance > 0.0)) return Vec3::UnitZ();
  const double depth = 1.0 - distance / influence_radius;
  return (depth * depth / distance) * d;
}

void obstacle_torque(const Chain& chain, const Poses& poses, std::span<const Vec3> centers,
                     double influence_radius, const JointVector& force_gains, JointVector& tau) {
  constexpr int kAvoidingJoints = 3;
  tau.setZero(chain.n);
  Jacobian J(6, chain.n);
  for (int i = 0; i < chain.n; ++i) {
    const Vec3& p = poses.p_0B[static_cast<std::size_t>(i)];
    Vec3 force = Vec3::Zero();
    for (const Vec3& center : centers) force += repulsion(p - center, influence_radius);
    if (force.isZero(0.0)) continue;
    point_jacobian(chain, poses, i, p, J);
    const int avoiding = std::min(kAvoidingJoints, chain.n);
    tau.head(avoiding) += J.topRows<3>().leftCols(avoiding).transpose() * (force_gains[i] * force);
  }
}

}  // namespace armtune
