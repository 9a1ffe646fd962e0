#pragma once
// Computes the inverse dynamics by the recursive Newton-Euler algorithm, the gravity torque, and the mass
// matrix by the composite rigid body algorithm (Featherstone, Rigid Body Dynamics Algorithms, sections 5.3
// and 6.2). Instead of spatial vectors, this code uses 3-vectors in body frames, and the classical
// acceleration of each body frame's origin.

#include "core/robot/friction.hpp"
#include "core/robot/kinematics.hpp"

namespace armtune::internal {

/// Computes tau = (M + D) q'' + C q' + g + Fv q' + Fc tanh(q'/0.05)  [N m, N].
/// qd: q' (n) [rad/s, m/s]. qdd: q'' (n) [rad/s^2, m/s^2]. poses: from `forward_kinematics` at q.
template <typename T>
void inverse_dynamics(const ChainT<T>& chain, const PosesT<T>& poses, const JointVectorT<T>& qd,
                      const JointVectorT<T>& qdd, JointVectorT<T>& tau) {
  std::array<Vec3T<T>, kMaxJoints> f;  // force at the body's origin that its motion needs, body frame
  std::array<Vec3T<T>, kMaxJoints> t;  // moment about the body's origin that its motion needs
  Vec3T<T> w = Vec3T<T>::Zero();
  Vec3T<T> w_dot = Vec3T<T>::Zero();
  Vec3T<T> a = -chain.gravity;  // acceleration of the origin minus gravity
  for (int i = 0; i < chain.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Mat3T<T>& R = poses.R_PB[k];
    const Vec3T<T>& p = poses.p_PB[k];
    const Vec3T<T> a_at_p = a + w_dot.cross(p) + w.cross(w.cross(p));
    const Vec3T<T> w_in_B = R.transpose() * w;
    const Vec3T<T> z = Vec3T<T>::UnitZ();
    w_dot = (R.transpose() * w_dot).eval();
    a.noalias() = R.transpose() * a_at_p;
    if (chain.motion[k] == JointMotion::kRevolute) {
      w_dot += z * qdd[i] + w_in_B.cross(z * qd[i]);
      w = w_in_B + z * qd[i];
    } else {
      a += z * qdd[i] + T(2) * w_in_B.cross(z * qd[i]);
      w = w_in_B;
    }
    const auto& link = chain.link[k];
    const Vec3T<T>& h = link.first_moment;
    f[k] = link.mass * a + w_dot.cross(h) + w.cross(w.cross(h));
    t[k] = h.cross(a) + link.inertia * w_dot + w.cross(link.inertia * w);
  }
  JointVectorT<T> coulomb;
  coulomb_directions(qd, chain.coulomb_friction, coulomb);
  tau.resize(chain.n);
  for (int i = chain.n - 1; i >= 0; --i) {
    const auto k = static_cast<std::size_t>(i);
    tau[i] = (chain.motion[k] == JointMotion::kRevolute ? t[k].z() : f[k].z()) +
             chain.rotor_inertia[i] * qdd[i] + chain.viscous_friction[i] * qd[i] +
             chain.coulomb_friction[i] * coulomb[i];
    if (i > 0) {
      const Vec3T<T> f_P = poses.R_PB[k] * f[k];
      f[k - 1] += f_P;
      t[k - 1] += poses.R_PB[k] * t[k] + poses.p_PB[k].cross(f_P);
    }
  }
}

/// Computes g(q), the torque that holds the arm still (n).
template <typename T>
void gravity_torque(const ChainT<T>& chain, const PosesT<T>& poses, JointVectorT<T>& tau) {
  const JointVectorT<T> zero = JointVectorT<T>::Zero(chain.n);
  inverse_dynamics(chain, poses, zero, zero, tau);
}

/// Computes M(q) (n x n) of the links only, without rotor inertia D.
template <typename T>
void mass_matrix(const ChainT<T>& chain, const PosesT<T>& poses, JointMatrixT<T>& M) {
  M.setZero(chain.n, chain.n);
  LinkInertiaT<T> composite = chain.link[static_cast<std::size_t>(chain.n - 1)];
  for (int i = chain.n - 1; i >= 0; --i) {
    const auto k = static_cast<std::size_t>(i);
    // Force and moment about body i's origin that accelerate all bodies from i on by a unit q'' of joint i.
    const Vec3T<T>& h = composite.first_moment;
    Vec3T<T> f;
    Vec3T<T> t;
    if (chain.motion[k] == JointMotion::kRevolute) {
      f = Vec3T<T>(-h.y(), h.x(), T(0));  // z x h
      t = composite.inertia.col(2);
    } else {
      f = Vec3T<T>(T(0), T(0), composite.mass);
      t = Vec3T<T>(h.y(), -h.x(), T(0));  // h x z
    }
    for (int j = i;; --j) {
      const auto l = static_cast<std::size_t>(j);
      M(j, i) = M(i, j) = chain.motion[l] == JointMotion::kRevolute ? t.z() : f.z();
      if (j == 0) break;
      f = (poses.R_PB[l] * f).eval();
      t = (poses.R_PB[l] * t).eval() + poses.p_PB[l].cross(f);
    }
    if (i > 0) {
      // Move the composite to the previous body's frame: rotate, then shift the origin by p.
      const Mat3T<T>& R = poses.R_PB[k];
      const Vec3T<T>& p = poses.p_PB[k];
      const Vec3T<T> h_P = R * h;
      const T m = composite.mass;
      const Mat3T<T> cross = h_P * p.transpose() + p * h_P.transpose();
      const T trace = T(2) * p.dot(h_P) + m * p.squaredNorm();
      LinkInertiaT<T> next = chain.link[k - 1];
      next.inertia += R * composite.inertia * R.transpose() + trace * Mat3T<T>::Identity() - cross -
                      m * p * p.transpose();
      next.first_moment += h_P + m * p;
      next.mass += m;
      composite = next;
    }
  }
}

}  // namespace armtune::internal
