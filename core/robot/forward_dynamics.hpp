#pragma once
// Forward dynamics by the articulated-body algorithm. Featherstone, Rigid Body Dynamics Algorithms, section
// 7.3; here in 3-vectors, body frames, with rotor inertia added to each joint's own articulated inertia,
// where it is exact.

#include "core/robot/friction.hpp"
#include "core/robot/kinematics.hpp"
#include "core/robot/symmetric3.hpp"

namespace armtune {

/// Work space of `forward_dynamics`: what its passes leave for the next one.
template <typename T>
struct ForwardDynamicsT {
  std::array<Vec3T<T>, kMaxJoints> v{};    ///< linear velocity of the body's origin, body frame
  std::array<Vec3T<T>, kMaxJoints> w{};    ///< angular velocity
  std::array<Vec3T<T>, kMaxJoints> U_f{};  ///< articulated inertia times the joint's axis: force
  std::array<Vec3T<T>, kMaxJoints> U_t{};  ///< and moment about the body's origin
  std::array<T, kMaxJoints> inverse_d{};   ///< 1 / (articulated inertia about the axis + rotor inertia)
  std::array<T, kMaxJoints> u{};           ///< torque that is left for acceleration
};
using ForwardDynamics = ForwardDynamicsT<double>;

/// Force of an articulated body, about the origin of its frame, for the spatial acceleration (a, w') of it:
///   f = M a + B w' + f0,   t = B^T a + I w' + t0.
template <typename T>
struct ArticulatedBodyT {
  Symmetric3T<T> M;  ///< [kg]
  Mat3T<T> B;        ///< [kg m]
  Symmetric3T<T> I;  ///< [kg m^2]
  Vec3T<T> f0;       ///< [N]
  Vec3T<T> t0;       ///< [N m]

  /// Adds a rigid body that moves with (v, w).
  void add(const LinkInertiaT<T>& link, const Vec3T<T>& v, const Vec3T<T>& w) {
    const Vec3T<T>& h = link.first_moment;
    const Vec3T<T> momentum = link.mass * v + w.cross(h);
    f0 += w.cross(momentum);
    t0 += w.cross(h.cross(v) + link.inertia * w) + v.cross(momentum);
    M.add_diagonal(link.mass);
    B(0, 1) += h.z();  // f = w' x h
    B(1, 0) -= h.z();
    B(0, 2) -= h.y();
    B(2, 0) += h.y();
    B(1, 2) += h.x();
    B(2, 1) -= h.x();
    I += Symmetric3T<T>::of(link.inertia);
  }

  /// The same body seen from the previous one's frame.
  ArticulatedBodyT in_parent(const Mat3T<T>& R_PB, const Vec3T<T>& p) const {
    ArticulatedBodyT moved;
    moved.M = rotated(R_PB, M);
    const Mat3T<T> turned = R_PB * (B * R_PB.transpose()).eval();
    const auto& N = moved.M;
    // turned - M [p]: a row times [p] is that row cross p.
    moved.B.row(0) = turned.row(0) - Vec3T<T>(N.xx, N.xy, N.xz).cross(p).transpose();
    moved.B.row(1) = turned.row(1) - Vec3T<T>(N.xy, N.yy, N.yz).cross(p).transpose();
    moved.B.row(2) = turned.row(2) - Vec3T<T>(N.xz, N.yz, N.zz).cross(p).transpose();
    // [p] B' - B^T [p] is symmetric: its entry (i, j) is (p x B_i)_j + (p x B'_j)_i, of columns.
    const Vec3T<T> b0 = p.cross(turned.col(0));
    const Vec3T<T> b1 = p.cross(turned.col(1));
    const Vec3T<T> b2 = p.cross(turned.col(2));
    const Vec3T<T> s0 = p.cross(moved.B.col(0));
    const Vec3T<T> s1 = p.cross(moved.B.col(1));
    const Vec3T<T> s2 = p.cross(moved.B.col(2));
    moved.I = rotated(R_PB, I);
    moved.I += {b0[0] + s0[0], b0[1] + s1[0], b0[2] + s2[0], b1[1] + s1[1], b1[2] + s2[1], b2[2] + s2[2]};
    moved.f0.noalias() = R_PB * f0;
    moved.t0 = R_PB * t0 + p.cross(moved.f0);
    return moved;
  }
};

/// y x z, of the joint axis z.
template <typename T>
Vec3T<T> cross_axis(const Vec3T<T>& y) {
  return {y.y(), -y.x(), T(0)};
}

/// Outwards: velocities of all bodies.
template <typename T>
void body_velocities(const ChainT<T>& chain, const PosesT<T>& poses, const JointVectorT<T>& qd,
                     ForwardDynamicsT<T>& s) {
  Vec3T<T> v = Vec3T<T>::Zero();
  Vec3T<T> w = Vec3T<T>::Zero();
  for (int i = 0; i < chain.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Mat3T<T>& R = poses.R_PB[k];
    v = R.transpose() * (v + w.cross(poses.p_PB[k])).eval();
    w = (R.transpose() * w).eval();
    (chain.motion[k] == JointMotion::kRevolute ? w : v).z() += qd[i];
    s.v[k] = v;
    s.w[k] = w;
  }
}

/// Inwards: each joint hands on what it cannot give way to.
template <typename T>
void articulated_bodies(const ChainT<T>& chain, const PosesT<T>& poses, const JointVectorT<T>& qd,
                        const JointVectorT<T>& torque, ForwardDynamicsT<T>& s) {
  ArticulatedBodyT<T> A{{}, Mat3T<T>::Zero(), {}, Vec3T<T>::Zero(), Vec3T<T>::Zero()};
  for (int i = chain.n - 1;; --i) {
    const auto k = static_cast<std::size_t>(i);
    const bool revolute = chain.motion[k] == JointMotion::kRevolute;
    A.add(chain.link[k], s.v[k], s.w[k]);
    const Vec3T<T> U_f = revolute ? Vec3T<T>(A.B.col(2)) : A.M.z_column();
    const Vec3T<T> U_t = revolute ? A.I.z_column() : Vec3T<T>(A.B.row(2).transpose());
    const T inverse_d = T(1) / ((revolute ? U_t.z() : U_f.z()) + chain.rotor_inertia[i]);
    const T u = torque[i] - chain.viscous_friction[i] * qd[i] -
                chain.coulomb_friction[i] * coulomb_direction(qd[i]) - (revolute ? A.t0.z() : A.f0.z());
    s.U_f[k] = U_f;
    s.U_t[k] = U_t;
    s.inverse_d[k] = inverse_d;
    s.u[k] = u;
    if (i == 0) return;
    const Vec3T<T> scaled_f = inverse_d * U_f;
    const Vec3T<T> scaled_t = inverse_d * U_t;
    A.M.subtract_square(inverse_d, U_f);
    A.B.noalias() -= scaled_f * U_t.transpose();
    A.I.subtract_square(inverse_d, U_t);
    // The joint's own turning accelerates the body by (v x z q', w x z q') without any q''.
    const Vec3T<T> w_x_z = cross_axis<T>(s.w[k]) * qd[i];
    A.f0 += scaled_f * u;
    A.t0 += scaled_t * u;
    if (revolute) {
      const Vec3T<T> v_x_z = cross_axis<T>(s.v[k]) * qd[i];
      A.f0 += A.M * v_x_z + A.B * w_x_z;
      A.t0 += A.B.transpose() * v_x_z + A.I * w_x_z;
    } else {
      A.f0 += A.M * w_x_z;
      A.t0 += A.B.transpose() * w_x_z;
    }
    A = A.in_parent(poses.R_PB[k], poses.p_PB[k]);
  }
}

/// Outwards: accelerations, against gravity.
template <typename T>
void joint_accelerations(const ChainT<T>& chain, const PosesT<T>& poses, const JointVectorT<T>& qd,
                         const ForwardDynamicsT<T>& s, JointVectorT<T>& qdd) {
  qdd.resize(chain.n);
  Vec3T<T> a = -chain.gravity;
  Vec3T<T> w_dot = Vec3T<T>::Zero();
  for (int i = 0; i < chain.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool revolute = chain.motion[k] == JointMotion::kRevolute;
    const Mat3T<T>& R = poses.R_PB[k];
    a = R.transpose() * (a + w_dot.cross(poses.p_PB[k])).eval();
    w_dot = (R.transpose() * w_dot).eval();
    const Vec3T<T> w_x_z = cross_axis<T>(s.w[k]) * qd[i];
    if (revolute) {
      a += cross_axis<T>(s.v[k]) * qd[i];
      w_dot += w_x_z;
    } else {
      a += w_x_z;
    }
    qdd[i] = s.inverse_d[k] * (s.u[k] - s.U_f[k].dot(a) - s.U_t[k].dot(w_dot));
    (revolute ? w_dot : a).z() += qdd[i];
  }
}

/// q'' (n) of (M + D) q'' + C q' + g + Fv q' + Fc tanh(q'/0.05) = torque. q', torque (n) in rad/s (m/s) and
/// N m (N); poses: `relative_poses` at q is enough. Singular only if a joint moves no inertia at all.
template <typename T>
void forward_dynamics(const ChainT<T>& chain, const PosesT<T>& poses, const JointVectorT<T>& qd,
                      const JointVectorT<T>& torque, ForwardDynamicsT<T>& s, JointVectorT<T>& qdd) {
  body_velocities(chain, poses, qd, s);
  articulated_bodies(chain, poses, qd, torque, s);
  joint_accelerations(chain, poses, qd, s, qdd);
}

}  // namespace armtune
