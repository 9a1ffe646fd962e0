#include "core/control/obstacle_impedance.hpp"

#include <algorithm>
#include <cmath>

#include "core/control/obstacle_distance.hpp"

namespace armtune::internal {
namespace {

constexpr int kAvoidingJoints = 3;

/// Adds the joint torques k_f,i J^T f of a repulsion f (length at most 1) at point p of body i.
void add_force(const Chain& chain, const Poses& poses, int i, const Vec3& p, const Vec3& f,
               const ForceGains& gains, Jacobian& J, JointVector& tau) {
  point_jacobian(chain, poses, i, p, J);
  const int avoiding = std::min(kAvoidingJoints, chain.n);
  const auto J_p = J.topRows<3>().leftCols(avoiding);
  if (!is_per_joint(gains, chain.n)) {
    const Vec3 force = gains[i] * f;
    tau.head(avoiding) += J_p.transpose() * force;
    return;
  }
  // One product for each joint, so that n equal gains and one number give bit-identical torques.
  for (int j = 0; j < avoiding; ++j) {
    const Vec3 force = force_gain(gains, chain.n, i, j) * f;
    const JointVector torque = J_p.transpose() * force;
    tau[j] += torque[j];
  }
}

/// Adds the force of the next joint due to a force at point p of link i, if that joint is prismatic and
/// lengthens the link. The point moves with the joint by its share of the link's length.
void add_drawing_out(const Chain& chain, const Poses& poses, int i, const Vec3& p, const Vec3& f,
                     const ForceGains& gains, JointVector& tau) {
  const int next = i + 1;
  const auto k = static_cast<std::size_t>(next);
  if (next >= std::min(kAvoidingJoints, chain.n) || chain.motion[k] != JointMotion::kPrismatic) return;
  const Vec3& from = poses.p_0B[static_cast<std::size_t>(i)];
  const double length = (poses.p_0B[k] - from).norm();
  const Vec3 force = force_gain(gains, chain.n, i, next) * f;
  if (length > 0.0) tau[next] += (p - from).norm() / length * poses.R_0B[k].col(2).dot(force);
}

}  // namespace

Vec3 repulsion(const Vec3& d, double influence_radius, double inside) {
  const double length = d.norm();
  const double distance = length - inside;
  if (!(distance < influence_radius)) return Vec3::Zero();
  // At the centre of the obstacle no direction is preferred; the base's z axis keeps the torque finite.
  if (!(length > 0.0)) return Vec3::UnitZ();
  const double depth = 1.0 - std::max(0.0, distance) / influence_radius;
  return (depth * depth / length) * d;
}

void obstacle_torque(const Chain& chain, const Poses& poses, std::span<const Obstacle> obstacles,
                     double influence_radius, const ForceGains& force_gains, JointVector& tau) {
  tau.setZero(chain.n);
  Jacobian J(6, chain.n);
  const bool links = chain.link_radius.size() > 0;
  for (int i = 0; i < chain.n; ++i) {
    const Vec3& origin = poses.p_0B[static_cast<std::size_t>(i)];
    Vec3 on_origin = Vec3::Zero();
    for (const Obstacle& obstacle : obstacles) {
      if (!links) {
        on_origin += repulsion(origin - obstacle.center, influence_radius, obstacle.radius);
        continue;
      }
      const Vec3 p = nearest_on_link(poses, i, obstacle.center);
      const Vec3 force =
          repulsion(p - obstacle.center, influence_radius, chain.link_radius[i] + obstacle.radius);
      if (force.isZero(0.0)) continue;
      add_force(chain, poses, i, p, force, force_gains, J, tau);
      add_drawing_out(chain, poses, i, p, force, force_gains, tau);
    }
    if (!on_origin.isZero(0.0)) add_force(chain, poses, i, origin, on_origin, force_gains, J, tau);
  }
}

}  // namespace armtune::internal
