#pragma once
// Forward dynamics by the articulated-body algorithm. Featherstone, Rigid Body Dynamics Algorithms, section
// 7.3; here in 3-vectors, body frames, with rotor inertia added to each joint's own articulated inertia,
// where it is exact. Linear and angular halves go through it as twins.

#include "core/robot/friction.hpp"
#include "core/robot/kinematics.hpp"
#include "core/robot/twin_vectors.hpp"

namespace armtune {

/// Work space of `forward_dynamics`: what its passes leave for the next one. Twins: linear and angular
/// velocity, of the body's origin and in its frame; force and moment about that origin.
template <typename T>
struct ForwardDynamicsT {
  std::array<TwinRotationT<T>, kMaxJoints> R_PB;
  std::array<TwinVec3T<T>, kMaxJoints> velocity;
  std::array<TwinVec3T<T>, kMaxJoints> turning;  ///< acceleration by the joint's own motion, without any q''
  std::array<TwinVec3T<T>, kMaxJoints> U;        ///< articulated inertia times the joint's axis
  std::array<T, kMaxJoints> inverse_d;           ///< 1 / (articulated inertia about the axis + rotor inertia)
  std::array<T, kMaxJoints> u;                   ///< torque that is left for acceleration
  JointVectorT<T> coulomb;                       ///< tanh(q'/0.05)
};
using ForwardDynamics = ForwardDynamicsT<double>;

/// Force of an articulated body, about the origin of its frame, for the spatial acceleration (a, w') of it:
///   f = M a + B w' + f0,   t = B^T a + I w' + t0.
template <typename T>
struct ArticulatedBodyT {
  TwinSymmetric3T<T> M_I;  ///< M [kg], I [kg m^2]
  SplitMat3T<T> B;         ///< [kg m]
  TwinVec3T<T> bias;       ///< f0 [N], t0 [N m]

  /// Adds a rigid body that moves with (v, w).
  void add(const LinkInertiaT<T>& link, const TwinVec3T<T>& velocity) {
    const Vec3T<T>& h = link.first_moment;
    const Mat3T<T>& I = link.inertia;
    const T zero(0);
    const TwinSymmetric3T<T> m_I = {{link.mass, I(0, 0)}, {zero, I(0, 1)}, {zero, I(0, 2)},
                                    {link.mass, I(1, 1)}, {zero, I(1, 2)}, {link.mass, I(2, 2)}};
    const Vec3T<T> v = velocity.first();
    const Vec3T<T> w = velocity.second();
    // (m v + w x h, I w + h x v), linear momentum and angular momentum about the origin.
    const TwinVec3T<T> momentum = m_I * velocity + TwinVec3T<T>(w, h).cross(TwinVec3T<T>(h, v));
    bias += TwinVec3T<T>(w, w).cross(momentum);
    bias.add_second(v.cross(momentum.first()));
    M_I += m_I;
    // B += -[h]: f = w' x h
    B.top[0] -= Twin<T>(zero, h.z());
    B.top[1] += Twin<T>(h.z(), zero);
    B.top[2] += Twin<T>(-h.y(), h.x());
    B.bottom[0] += h.y();
    B.bottom[1] -= h.x();
  }

  /// The same body seen from the previous one's frame.
  ArticulatedBodyT in_parent(const TwinRotationT<T>& R, const Mat3T<T>& R_PB, const Vec3T<T>& p) const {
    ArticulatedBodyT moved;
    moved.M_I = rotated(R, M_I);
    const SplitMat3T<T> turned = rotated(R, R_PB, B);
    // B' = turned - M [p]: a row times [p] is that row cross p.
    const TwinSymmetric3T<T>& N = moved.M_I;
    const TwinVec3T<T> upper({N.xx.first(), N.xy.first()}, {N.xy.first(), N.yy.first()},
                             {N.xz.first(), N.yz.first()});
    const TwinVec3T<T> at_p = upper.cross(TwinVec3T<T>::both(p));
    moved.B.top[0] = turned.top[0] - at_p.x;
    moved.B.top[1] = turned.top[1] - at_p.y;
    moved.B.top[2] = turned.top[2] - at_p.z;
    const T &xz = N.xz.first(), &yz = N.yz.first(), &zz = N.zz.first();
    moved.B.bottom[0] = turned.bottom[0] - (yz * p[2] - zz * p[1]);
    moved.B.bottom[1] = turned.bottom[1] - (zz * p[0] - xz * p[2]);
    moved.B.bottom[2] = turned.bottom[2] - (xz * p[1] - yz * p[0]);
    // [p] turned - B'^T [p], which is symmetric: its entry (i, j) is (p x turned_j)_i + (p x B'_i)_j, of
    // columns.
    const SplitMat3T<T>& C = turned;
    const SplitMat3T<T>& D = moved.B;
    const T zero(0);
    moved.M_I += {{zero, p[1] * (C(2, 0) + D(2, 0)) - p[2] * (C(1, 0) + D(1, 0))},
                  {zero, p[2] * C(0, 0) - p[0] * C(2, 0) + (p[1] * D(2, 1) - p[2] * D(1, 1))},
                  {zero, p[0] * C(1, 0) - p[1] * C(0, 0) + (p[1] * D(2, 2) - p[2] * D(1, 2))},
                  {zero, p[2] * (C(0, 1) + D(0, 1)) - p[0] * (C(2, 1) + D(2, 1))},
                  {zero, p[0] * C(1, 1) - p[1] * C(0, 1) + (p[2] * D(0, 2) - p[0] * D(2, 2))},
                  {zero, p[0] * (C(1, 2) + D(1, 2)) - p[1] * (C(0, 2) + D(0, 2))}};
    moved.bias = R * bias;
    moved.bias.add_second(p.cross(moved.bias.first()));
    return moved;
  }
};

/// Outwards: velocities of all bodies.
template <typename T>
void body_velocities(const ChainT<T>& chain, const PosesT<T>& poses, const JointVectorT<T>& qd,
                     ForwardDynamicsT<T>& s) {
  TwinVec3T<T> V = TwinVec3T<T>::zero();
  const T zero(0);
  for (int i = 0; i < chain.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const TwinRotationT<T> R(poses.R_PB[k]);
    s.R_PB[k] = R;
    V.add_first(V.second().cross(poses.p_PB[k]));
    V = back(R, V);
    // The joint's own turning accelerates the body by (v x z q', w x z q') without any q''.
    if (chain.motion[k] == JointMotion::kRevolute) {
      s.turning[k] = Twin<T>::both(qd[i]) * V.cross_axis();
      V.z += Twin<T>(zero, qd[i]);
    } else {
      const Vec3T<T> w = V.second();
      s.turning[k] = TwinVec3T<T>({w.y() * qd[i], -w.x() * qd[i], zero}, Vec3T<T>::Zero());
      V.z += Twin<T>(qd[i], zero);
    }
    s.velocity[k] = V;
  }
}

/// Inwards: each joint hands on what it cannot give way to.
template <typename T>
void articulated_bodies(const ChainT<T>& chain, const PosesT<T>& poses, const JointVectorT<T>& qd,
                        const JointVectorT<T>& torque, ForwardDynamicsT<T>& s) {
  const Twin<T> none = Twin<T>::both(T(0));
  ArticulatedBodyT<T> A{{none, none, none, none, none, none}, SplitMat3T<T>::zero(), TwinVec3T<T>::zero()};
  for (int i = chain.n - 1;; --i) {
    const auto k = static_cast<std::size_t>(i);
    const bool revolute = chain.motion[k] == JointMotion::kRevolute;
    A.add(chain.link[k], s.velocity[k]);
    const TwinVec3T<T> z = A.M_I.z_column();
    const TwinVec3T<T> U =
        revolute ? TwinVec3T<T>(A.B.column(2), z.second()) : TwinVec3T<T>(z.first(), A.B.last_row());
    const T inverse_d = T(1) / ((revolute ? U.z.second() : U.z.first()) + chain.rotor_inertia[i]);
    const T u = torque[i] - chain.viscous_friction[i] * qd[i] - chain.coulomb_friction[i] * s.coulomb[i] -
                (revolute ? A.bias.z.second() : A.bias.z.first());
    s.U[k] = U;
    s.inverse_d[k] = inverse_d;
    s.u[k] = u;
    if (i == 0) return;
    const TwinVec3T<T> scaled = Twin<T>::both(inverse_d) * U;
    A.M_I.subtract_square(scaled, U);
    const Twin<T> scaled_xy(scaled.x.first(), scaled.y.first());
    A.B.top[0] -= scaled_xy * Twin<T>::both(U.x.second());
    A.B.top[1] -= scaled_xy * Twin<T>::both(U.y.second());
    A.B.top[2] -= scaled_xy * Twin<T>::both(U.z.second());
    A.B.bottom[0] -= scaled.z.first() * U.x.second();
    A.B.bottom[1] -= scaled.z.first() * U.y.second();
    A.B.bottom[2] -= scaled.z.first() * U.z.second();
    const TwinVec3T<T>& c = s.turning[k];  // its z is zero
    const TwinVec3T<T> columns =
        c.x * TwinVec3T<T>(A.M_I.xx, A.M_I.xy, A.M_I.xz) + c.y * TwinVec3T<T>(A.M_I.xy, A.M_I.yy, A.M_I.yz);
    const Twin<T> cx(c.x.second(), c.x.first());
    const Twin<T> cy(c.y.second(), c.y.first());
    const SplitMat3T<T>& B = A.B;
    A.bias += Twin<T>::both(u) * scaled + columns;
    A.bias += TwinVec3T<T>(cx * Twin<T>(B(0, 0), B(0, 0)) + cy * Twin<T>(B(0, 1), B(1, 0)),
                           cx * Twin<T>(B(1, 0), B(0, 1)) + cy * Twin<T>(B(1, 1), B(1, 1)),
                           cx * Twin<T>(B(2, 0), B(0, 2)) + cy * Twin<T>(B(2, 1), B(1, 2)));
    A = A.in_parent(s.R_PB[k], poses.R_PB[k], poses.p_PB[k]);
  }
}

/// Outwards: accelerations, against gravity.
template <typename T>
void joint_accelerations(const ChainT<T>& chain, const PosesT<T>& poses, const ForwardDynamicsT<T>& s,
                         JointVectorT<T>& qdd) {
  qdd.resize(chain.n);
  const T zero(0);
  TwinVec3T<T> a(Vec3T<T>(-chain.gravity), Vec3T<T>::Zero());
  for (int i = 0; i < chain.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    a.add_first(a.second().cross(poses.p_PB[k]));
    a = back(s.R_PB[k], a) + s.turning[k];
    const Twin<T> taken = s.U[k].dot(a);
    qdd[i] = s.inverse_d[k] * (s.u[k] - taken.first() - taken.second());
    a.z += chain.motion[k] == JointMotion::kRevolute ? Twin<T>(zero, qdd[i]) : Twin<T>(qdd[i], zero);
  }
}

/// q'' (n) of (M + D) q'' + C q' + g + Fv q' + Fc tanh(q'/0.05) = torque. q', torque (n) in rad/s (m/s) and
/// N m (N); poses: `relative_poses` at q is enough. Singular only if a joint moves no inertia at all.
template <typename T>
void forward_dynamics(const ChainT<T>& chain, const PosesT<T>& poses, const JointVectorT<T>& qd,
                      const JointVectorT<T>& torque, ForwardDynamicsT<T>& s, JointVectorT<T>& qdd) {
  coulomb_directions(qd, chain.coulomb_friction, s.coulomb);
  body_velocities(chain, poses, qd, s);
  articulated_bodies(chain, poses, qd, torque, s);
  joint_accelerations(chain, poses, s, qdd);
}

}  // namespace armtune
