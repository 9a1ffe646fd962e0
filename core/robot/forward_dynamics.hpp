#pragma once
// Forward dynamics by the articulated-body algorithm. Featherstone, Rigid Body Dynamics Algorithms, section
// 7.3; here in 3-vectors, body frames, with rotor inertia added to each joint's own articulated inertia,
// where it is exact.

#include "core/robot/friction.hpp"
#include "core/robot/kinematics.hpp"
#include "core/robot/symmetric3.hpp"

namespace armtune {

/// Force of an articulated body about the origin of its frame, for the spatial acceleration (a, w') of it:
///   f = M a + B w',   t = B^T a + I w'.
template <typename T>
struct ArticulatedInertiaT {
  Symmetric3T<T> M;  ///< [kg]
  Mat3T<T> B;        ///< [kg m]
  Symmetric3T<T> I;  ///< [kg m^2]
};

/// Work space of `forward_dynamics`: what its passes leave for the next one.
template <typename T>
struct ForwardDynamicsT {
  std::array<Vec3T<T>, kMaxJoints> w{};  ///< angular velocity of the body, body frame
  std::array<Vec3T<T>, kMaxJoints> v{};  ///< linear velocity of its origin
  std::array<ArticulatedInertiaT<T>, kMaxJoints> inertia{};
  std::array<Vec3T<T>, kMaxJoints> bias_f{};  ///< articulated bias force
  std::array<Vec3T<T>, kMaxJoints> bias_t{};  ///< and moment
  std::array<Vec3T<T>, kMaxJoints> U_f{};     ///< articulated inertia times the joint's axis
  std::array<Vec3T<T>, kMaxJoints> U_t{};
  std::array<T, kMaxJoints> inverse_d{};  ///< of the joint's articulated inertia, rotor included
  std::array<T, kMaxJoints> u{};          ///< torque left for it
};
using ForwardDynamics = ForwardDynamicsT<double>;

/// [x]: [x] y = x cross y.
template <typename T>
Mat3T<T> cross_matrix(const Vec3T<T>& x) {
  Mat3T<T> X;
  X << T(0), -x.z(), x.y(), x.z(), T(0), -x.x(), -x.y(), x.x(), T(0);
  return X;
}

/// The same inertia about the previous body's origin, in its axes, added to what that body has already.
template <typename T>
void add_to_parent(const ArticulatedInertiaT<T>& body, const Mat3T<T>& R_PB, const Vec3T<T>& p_PB,
                   ArticulatedInertiaT<T>& parent) {
  const Symmetric3T<T> M = rotated(R_PB, body.M);
  const Mat3T<T> B = R_PB * (body.B * R_PB.transpose()).eval();
  const Vec3T<T>& p = p_PB;
  // B - M [p], row by row: a row of M times [p] is that row cross p.
  Mat3T<T> shifted;
  shifted.row(0) = B.row(0) - Vec3T<T>(M.xx, M.xy, M.xz).cross(p).transpose();
  shifted.row(1) = B.row(1) - Vec3T<T>(M.xy, M.yy, M.yz).cross(p).transpose();
  shifted.row(2) = B.row(2) - Vec3T<T>(M.xz, M.yz, M.zz).cross(p).transpose();
  parent.M += M;
  parent.B += shifted;
  parent.I += rotated(R_PB, body.I);
  // [p] shifted - B^T [p] is symmetric: its entry (i, j) is (p x B_i)_j + (p x shifted_j)_i, of columns.
  const Vec3T<T> b0 = p.cross(B.col(0));
  const Vec3T<T> b1 = p.cross(B.col(1));
  const Vec3T<T> b2 = p.cross(B.col(2));
  const Vec3T<T> s0 = p.cross(shifted.col(0));
  const Vec3T<T> s1 = p.cross(shifted.col(1));
  const Vec3T<T> s2 = p.cross(shifted.col(2));
  parent.I += {b0[0] + s0[0], b0[1] + s1[0], b0[2] + s2[0], b1[1] + s1[1], b1[2] + s2[1], b2[2] + s2[2]};
}

/// q'' (n) of (M + D) q'' + C q' + g + Fv q' + Fc tanh(q'/0.05) = torque. q', torque (n) in rad/s (m/s) and
/// N m (N); poses: `relative_poses` at q is enough. Singular only if a joint moves no inertia at all.
template <typename T>
void forward_dynamics(const ChainT<T>& chain, const PosesT<T>& poses, const JointVectorT<T>& qd,
                      const JointVectorT<T>& torque, ForwardDynamicsT<T>& s, JointVectorT<T>& qdd) {
  const int n = chain.n;
  // Outwards: velocities, and the force that each body needs to keep them.
  Vec3T<T> v = Vec3T<T>::Zero();
  Vec3T<T> w = Vec3T<T>::Zero();
  for (int i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Mat3T<T>& R = poses.R_PB[k];
    v = R.transpose() * (v + w.cross(poses.p_PB[k])).eval();
    w = (R.transpose() * w).eval();
    (chain.motion[k] == JointMotion::kRevolute ? w : v).z() += qd[i];
    s.v[k] = v;
    s.w[k] = w;
    const LinkInertiaT<T>& link = chain.link[k];
    const Vec3T<T>& h = link.first_moment;
    const Vec3T<T> momentum = link.mass * v + w.cross(h);
    s.bias_f[k] = w.cross(momentum);
    s.bias_t[k] = w.cross(h.cross(v) + link.inertia * w) + v.cross(momentum);
    s.inertia[k].M = Symmetric3T<T>::diagonal(link.mass);
    s.inertia[k].B = -cross_matrix<T>(h);
    s.inertia[k].I = Symmetric3T<T>::of(link.inertia);
  }
  // Inwards: each joint hands on what it cannot give way to.
  for (int i = n - 1; i >= 0; --i) {
    const auto k = static_cast<std::size_t>(i);
    const bool revolute = chain.motion[k] == JointMotion::kRevolute;
    ArticulatedInertiaT<T>& A = s.inertia[k];
    s.U_f[k] = revolute ? Vec3T<T>(A.B.col(2)) : A.M.z_column();
    s.U_t[k] = revolute ? A.I.z_column() : Vec3T<T>(A.B.row(2).transpose());
    const T d = (revolute ? s.U_t[k].z() : s.U_f[k].z()) + chain.rotor_inertia[i];
    s.inverse_d[k] = T(1) / d;
    s.u[k] = torque[i] - chain.viscous_friction[i] * qd[i] -
             chain.coulomb_friction[i] * coulomb_direction(qd[i]) -
             (revolute ? s.bias_t[k].z() : s.bias_f[k].z());
    if (i == 0) break;
    const Vec3T<T> scaled_f = s.inverse_d[k] * s.U_f[k];
    const Vec3T<T> scaled_t = s.inverse_d[k] * s.U_t[k];
    A.M.subtract_square(s.inverse_d[k], s.U_f[k]);
    A.B.noalias() -= scaled_f * s.U_t[k].transpose();
    A.I.subtract_square(s.inverse_d[k], s.U_t[k]);
    // The joint's own turning makes (v x z q', w x z q') without any q''.
    const Vec3T<T> turn(s.w[k].y() * qd[i], -s.w[k].x() * qd[i], T(0));
    Vec3T<T> f = s.bias_f[k] + scaled_f * s.u[k];
    Vec3T<T> t = s.bias_t[k] + scaled_t * s.u[k];
    if (revolute) {
      const Vec3T<T> slide(s.v[k].y() * qd[i], -s.v[k].x() * qd[i], T(0));
      f += A.M * slide + A.B * turn;
      t += A.B.transpose() * slide + A.I * turn;
    } else {
      f += A.M * turn;
      t += A.B.transpose() * turn;
    }
    add_to_parent(A, poses.R_PB[k], poses.p_PB[k], s.inertia[k - 1]);
    const Vec3T<T> f_P = poses.R_PB[k] * f;
    s.bias_f[k - 1] += f_P;
    s.bias_t[k - 1] += poses.R_PB[k] * t + poses.p_PB[k].cross(f_P);
  }
  // Outwards: accelerations, against gravity.
  qdd.resize(n);
  Vec3T<T> a = -chain.gravity;
  Vec3T<T> w_dot = Vec3T<T>::Zero();
  for (int i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool revolute = chain.motion[k] == JointMotion::kRevolute;
    const Mat3T<T>& R = poses.R_PB[k];
    a = R.transpose() * (a + w_dot.cross(poses.p_PB[k])).eval();
    w_dot = (R.transpose() * w_dot).eval();
    const Vec3T<T> turn(s.w[k].y() * qd[i], -s.w[k].x() * qd[i], T(0));
    if (revolute) {
      a += Vec3T<T>(s.v[k].y() * qd[i], -s.v[k].x() * qd[i], T(0));
      w_dot += turn;
    } else {
      a += turn;
    }
    qdd[i] = s.inverse_d[k] * (s.u[k] - s.U_f[k].dot(a) - s.U_t[k].dot(w_dot));
    (revolute ? w_dot : a).z() += qdd[i];
  }
}

}  // namespace armtune
