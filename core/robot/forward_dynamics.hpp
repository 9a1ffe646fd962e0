#pragma once
// Forward dynamics: computes joint accelerations from joint torques by the articulated-body algorithm
// (Featherstone, Rigid Body Dynamics Algorithms, section 7.3). All 3-vectors have the axes of the base. From
// joint to joint, an articulated inertia is therefore only shifted to a new origin and never rotated. Rotor
// inertia is added to the articulated inertia about each joint's own axis, which is exact. Linear and angular
// parts are computed side by side, as pairs of numbers called twins (common/twin.hpp).

#include "core/robot/friction_step.hpp"
#include "core/robot/kinematics.hpp"
#include "core/robot/turned_link.hpp"
#include "core/robot/twin_vectors.hpp"

namespace armtune::internal {

/// The workspace of `forward_dynamics`: intermediate results that its passes share, with the axes of the
/// base. A twin holds either the linear and the angular motion of a body at its origin, or the force and the
/// moment about that origin.
template <typename T>
struct ForwardDynamicsT {
  std::array<Vec3T<T>, kMaxJoints> arm;  ///< from the previous body's origin to this body's origin
  std::array<TwinVec3T<T>, kMaxJoints> velocity;
  std::array<TwinVec3T<T>, kMaxJoints> turning;  ///< acceleration due to the joint's velocity, at q'' = 0
  std::array<TwinVec3T<T>, kMaxJoints> U;        ///< articulated inertia times the joint's axis
  std::array<T, kMaxJoints> inverse_d;           ///< 1 / (articulated inertia about the axis + rotor inertia)
  std::array<T, kMaxJoints> u;                   ///< joint torque minus friction and bias force
  JointVectorT<T> coulomb;                       ///< tanh(q'/0.05)
};
using ForwardDynamics = ForwardDynamicsT<double>;

/// The force of an articulated body, about its origin, as a function of its spatial acceleration (a, w'):
///   f = M a + B w' + f0,   t = B^T a + I w' + t0.
template <typename T>
struct ArticulatedBodyT {
  TwinSymmetric3T<T> M_I;  ///< M [kg], I [kg m^2]
  SplitMat3T<T> B;         ///< [kg m]
  TwinVec3T<T> bias;       ///< f0 [N], t0 [N m]

  static ArticulatedBodyT none() {
    const Twin<T> zero = Twin<T>::both(T(0));
    return {{zero, zero, zero, zero, zero, zero}, SplitMat3T<T>::zero(), TwinVec3T<T>::zero()};
  }

  /// Adds a rigid body that moves with (v, w).
  [[gnu::always_inline]] void add(const TurnedLinkT<T>& link, const TwinVec3T<T>& velocity) {
    const Vec3T<T>& h = link.first_moment;
    const Vec3T<T> v = velocity.first();
    const Vec3T<T> w = velocity.second();
    // (m v + w x h, I w + h x v), linear momentum and angular momentum about the origin.
    const TwinVec3T<T> momentum =
        TwinVec3T<T>(link.mass * v, link.inertia_times(w)) + TwinVec3T<T>(w, h).cross(TwinVec3T<T>(h, v));
    bias += TwinVec3T<T>::both(w).cross(momentum);
    bias.add_second(v.cross(momentum.first()));
    M_I.xx += Twin<T>(link.mass, link.xx);
    M_I.yy += Twin<T>(link.mass, link.yy);
    M_I.zz += Twin<T>(link.mass, link.zz);
    M_I.xy.add_second(link.xy);
    M_I.xz.add_second(link.xz);
    M_I.yz.add_second(link.yz);
    // B += -[h]: f = w' x h
    B.top[0].add_second(-h.z());
    B.top[1].add_first(h.z());
    B.top[2] += Twin<T>(-h.y(), h.x());
    B.bottom[0] += h.y();
    B.bottom[1] -= h.x();
  }

  /// Returns the force and moment for unit acceleration along, or about, the axis z.
  [[gnu::always_inline]] TwinVec3T<T> along(const Vec3T<T>& z, JointMotion motion) const {
    return motion == JointMotion::kRevolute ? TwinVec3T<T>(B * z, M_I.second_times(z))
                                            : TwinVec3T<T>(M_I.first_times(z), B.transposed_times(z));
  }

  /// Subtracts U U^T / d. The previous body does not feel this part of the inertia, because the joint between
  /// the two moves freely. scaled: U / d.
  [[gnu::always_inline]] void subtract(const TwinVec3T<T>& scaled, const TwinVec3T<T>& U) {
    M_I.subtract_square(scaled, U);
    B.subtract_product(scaled.first(), U.second());
  }

  /// Adds to the bias the force that the acceleration c needs.
  [[gnu::always_inline]] void accelerate(const TwinVec3T<T>& c) {
    bias += M_I * c + TwinVec3T<T>(B * c.second(), B.transposed_times(c.first()));
  }

  /// Moves the body's origin to another point. p: vector from that point to the present origin.
  [[gnu::always_inline]] void move_origin(const Vec3T<T>& p) {
    const SplitMat3T<T> C = B;
    // B' = B - M [p]: a row times [p] is that row cross p.
    const TwinSymmetric3T<T>& N = M_I;
    const TwinVec3T<T> upper({N.xx.first(), N.xy.first()}, {N.xy.first(), N.yy.first()},
                             {N.xz.first(), N.yz.first()});
    const TwinVec3T<T> at_p = upper.cross(TwinVec3T<T>::both(p));
    B.top[0] -= at_p.x;
    B.top[1] -= at_p.y;
    B.top[2] -= at_p.z;
    const T &xz = N.xz.first(), &yz = N.yz.first(), &zz = N.zz.first();
    B.bottom[0] -= yz * p[2] - zz * p[1];
    B.bottom[1] -= zz * p[0] - xz * p[2];
    B.bottom[2] -= xz * p[1] - yz * p[0];
    // Add [p] B - B'^T [p], which is symmetric. Its entry (i, j) is (p x B_j)_i + (p x B'_i)_j, where B_j is
    // column j of B.
    const SplitMat3T<T>& D = B;
    M_I.xx.add_second(p[1] * (C(2, 0) + D(2, 0)) - p[2] * (C(1, 0) + D(1, 0)));
    M_I.xy.add_second(p[2] * C(0, 0) - p[0] * C(2, 0) + (p[1] * D(2, 1) - p[2] * D(1, 1)));
    M_I.xz.add_second(p[0] * C(1, 0) - p[1] * C(0, 0) + (p[1] * D(2, 2) - p[2] * D(1, 2)));
    M_I.yy.add_second(p[2] * (C(0, 1) + D(0, 1)) - p[0] * (C(2, 1) + D(2, 1)));
    M_I.yz.add_second(p[0] * C(1, 1) - p[1] * C(0, 1) + (p[2] * D(0, 2) - p[0] * D(2, 2)));
    M_I.zz.add_second(p[0] * (C(1, 2) + D(1, 2)) - p[1] * (C(0, 2) + D(0, 2)));
    bias.add_second(p.cross(bias.first()));
  }
};

/// Computes the velocities of all bodies, from the base outwards.
template <typename T>
void body_velocities(const ChainT<T>& chain, const PosesT<T>& poses, const JointVectorT<T>& qd,
                     ForwardDynamicsT<T>& s) {
  TwinVec3T<T> V = TwinVec3T<T>::zero();
  Vec3T<T> origin = Vec3T<T>::Zero();
  for (int i = 0; i < chain.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    s.arm[k] = poses.p_0B[k] - origin;
    origin = poses.p_0B[k];
    V.add_first(V.second().cross(s.arm[k]));
    // The turning of a revolute joint accelerates the body by (v x z q', w x z q'), even if q'' is zero.
    const Vec3T<T> along = poses.R_0B[k].col(2) * qd[i];
    if (chain.motion[k] == JointMotion::kRevolute) {
      s.turning[k] = V.cross(TwinVec3T<T>::both(along));
      V.add_second(along);
    } else {
      s.turning[k] = TwinVec3T<T>(V.second().cross(along), Vec3T<T>::Zero());
      V.add_first(along);
    }
    s.velocity[k] = V;
  }
}

/// Computes the articulated bodies, from the tip inwards. Each joint passes to the previous body the force
/// that its own motion does not absorb.
template <typename T, typename Friction>
void articulated_bodies(const ChainT<T>& chain, const PosesT<T>& poses, const JointVectorT<T>& qd,
                        const JointVectorT<T>& torque, const Friction& friction, ForwardDynamicsT<T>& s) {
  ArticulatedBodyT<T> A = ArticulatedBodyT<T>::none();
  for (int i = chain.n - 1;; --i) {
    const auto k = static_cast<std::size_t>(i);
    const bool revolute = chain.motion[k] == JointMotion::kRevolute;
    A.add(turned(chain.link[k], poses.R_0B[k]), s.velocity[k]);
    const Vec3T<T> z = poses.R_0B[k].col(2);
    const TwinVec3T<T> U = A.along(z, chain.motion[k]);
    T d = dot3(z, revolute ? U.second() : U.first()) + chain.rotor_inertia[i];
    T u = torque[i] - chain.viscous_friction[i] * qd[i] - chain.coulomb_friction[i] * s.coulomb[i] -
          dot3(z, revolute ? A.bias.second() : A.bias.first());
    friction.add(chain, i, qd[i], d, u);
    const T inverse_d = T(1) / d;
    s.U[k] = U;
    s.inverse_d[k] = inverse_d;
    s.u[k] = u;
    if (i == 0) return;
    const TwinVec3T<T> scaled = Twin<T>::both(inverse_d) * U;
    A.subtract(scaled, U);
    A.bias += Twin<T>::both(u) * scaled;
    A.accelerate(s.turning[k]);
    A.move_origin(s.arm[k]);
  }
}

/// Computes the joint accelerations, from the base outwards. Gravity enters as an upward acceleration of the
/// base.
template <typename T>
void joint_accelerations(const ChainT<T>& chain, const PosesT<T>& poses, const ForwardDynamicsT<T>& s,
                         JointVectorT<T>& qdd) {
  qdd.resize(chain.n);
  TwinVec3T<T> a(Vec3T<T>(-chain.gravity), Vec3T<T>::Zero());
  for (int i = 0; i < chain.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    a.add_first(a.second().cross(s.arm[k]));
    a += s.turning[k];
    const Twin<T> taken = s.U[k].dot(a);
    qdd[i] = s.inverse_d[k] * (s.u[k] - taken.first() - taken.second());
    const Vec3T<T> along = poses.R_0B[k].col(2) * qdd[i];
    if (chain.motion[k] == JointMotion::kRevolute) {
      a.add_second(along);
    } else {
      a.add_first(along);
    }
  }
}

/// Computes q'' (n) [rad/s^2, m/s^2] from  (M + D) q'' + C q' + g + Fv q' + Fc tanh(q'/0.05) = torque.
/// qd: q' (n) [rad/s, m/s]. torque (n) [N m, N]. poses: from `body_poses` at q. friction: FrictionStep
/// within a step of the integration, InstantFriction for q'' at one instant. The equation is singular only if
/// a joint moves no inertia at all.
template <typename T, typename Friction>
void forward_dynamics(const ChainT<T>& chain, const PosesT<T>& poses, const JointVectorT<T>& qd,
                      const JointVectorT<T>& torque, const Friction& friction, ForwardDynamicsT<T>& s,
                      JointVectorT<T>& qdd) {
  coulomb_directions(qd, chain.coulomb_friction, s.coulomb);
  body_velocities(chain, poses, qd, s);
  articulated_bodies(chain, poses, qd, torque, friction, s);
  joint_accelerations(chain, poses, s, qdd);
}
template <typename T>
void forward_dynamics(const ChainT<T>& chain, const PosesT<T>& poses, const JointVectorT<T>& qd,
                      const JointVectorT<T>& torque, ForwardDynamicsT<T>& s, JointVectorT<T>& qdd) {
  forward_dynamics(chain, poses, qd, torque, InstantFriction{}, s, qdd);
}

}  // namespace armtune::internal
