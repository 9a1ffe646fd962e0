#pragma once
// The Slotine-Li regressor Y of an arm:
//   Y(q, q', qr', qr'') theta = (M + D) qr'' + C(q, q') qr' + g + friction(q').
// D is the diagonal matrix of the rotors' inertia, and C the Coriolis matrix for which dM/dt - 2C is
// skew-symmetric. Control laws use Y for the torque Y theta of their arm model. Adaptation and identification
// use it to estimate theta (theta.hpp). Sources: Slotine and Li, On the adaptive control of robot
// manipulators, 1987. The recursion is that of Niemeyer and Slotine, Performance in adaptive manipulator
// control, 1991.
//
// In spatial notation (Featherstone), with capital letters for spatial vectors, the force on body i is
//   F = I (Ar - V x Vr / 2) + V x* (I Vr) / 2 + Vr x* (I V) / 2,   with Ar_i = X Ar + S qr'' + V_i x S qr',
// where X transforms from the previous body's frame, and S is the motion of joint i at unit velocity. The
// code multiplies this out in 3-vectors, each pair linear and angular: V = (v, w), Vr = (vr, wr),
// Ar = (ar, br), F = (f, t). A body has the mass m, the first moment h and the rotational inertia I about its
// frame's origin. With
//   e = ar + wr x v,     a = br - w x wr / 2,
// the terms with h are simplified by Jacobi's identity, and the force is
//   f = m e + a x h + (w x (wr x h) + wr x (w x h)) / 2
//   t = h x e + I a + (w x (I wr) + wr x (I w)) / 2.

#include "core/robot/friction.hpp"
#include "core/robot/kinematics.hpp"
#include "core/robot/theta.hpp"
#include "core/robot/twin_vectors.hpp"

namespace armtune::internal {

/// The motion of every body for one (q, q', qr', qr''), from which Y theta, Y^T S and Y are computed. Each
/// twin (common/twin.hpp) holds the linear and the angular motion of the body's origin, in the body's frame.
template <typename T>
struct SlotineLiT {
  int n = 0;
  std::array<TwinVec3T<T>, kMaxJoints> velocity;      ///< (v, w)
  std::array<TwinVec3T<T>, kMaxJoints> reference;     ///< (vr, wr)
  std::array<TwinVec3T<T>, kMaxJoints> acceleration;  ///< (e, a), effective, including gravity
  JointVectorT<T> qd;
  JointVectorT<T> qdr;
  JointVectorT<T> qddr;
  JointVectorT<T> coulomb;  ///< tanh(q'/0.05)
};
using SlotineLi = SlotineLiT<double>;

/// Computes the motion of all bodies, from the base outwards. qd: measured q'; qdr, qddr: references qr' and
/// qr'' (n each).
template <typename T>
void slotine_li_forward(const ChainT<T>& chain, const PosesT<T>& poses, const JointVectorT<T>& qd,
                        const JointVectorT<T>& qdr, const JointVectorT<T>& qddr, SlotineLiT<T>& s) {
  s.n = chain.n;
  s.qd = qd;
  s.qdr = qdr;
  s.qddr = qddr;
  coulomb_directions(qd, s.coulomb);
  TwinVec3T<T> V = TwinVec3T<T>::zero();
  TwinVec3T<T> Vr = TwinVec3T<T>::zero();
  TwinVec3T<T> A(Vec3T<T>(-chain.gravity), Vec3T<T>::Zero());  // spatial reference acceleration
  for (int i = 0; i < chain.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Vec3T<T>& p = poses.p_PB[k];
    const Mat3T<T>& R = poses.R_PB[k];
    V.add_first(V.second().cross(p));
    Vr.add_first(Vr.second().cross(p));
    A.add_first(A.second().cross(p));
    V = transposed_times(R, V);
    Vr = transposed_times(R, Vr);
    A = transposed_times(R, A);
    // v_i x S qr' with S along z (the velocity's own S q' part drops out of it).
    if (chain.motion[k] == JointMotion::kRevolute) {
      A += Twin<T>::both(qdr[i]) * V.cross_axis();
      A.z.add_second(qddr[i]);
      V.z.add_second(qd[i]);
      Vr.z.add_second(qdr[i]);
    } else {
      const Vec3T<T> w = V.second();
      A.add_first(Vec3T<T>(w.y() * qdr[i], -w.x() * qdr[i], qddr[i]));
      V.z.add_first(qd[i]);
      Vr.z.add_first(qdr[i]);
    }
    s.velocity[k] = V;
    s.reference[k] = Vr;
    // (wr x v, -w x wr / 2)
    const Vec3T<T> wr = Vr.second();
    const TwinVec3T<T> turned = TwinVec3T<T>::both(wr).cross(V);
    s.acceleration[k] = A + Twin<T>(T(1), T(0.5)) * turned;
  }
}

/// Returns the inertia matrix of a link's ten parameters twice, as the first and as the second matrix.
template <typename T, typename Link>
TwinSymmetric3T<T> inertia_twice(const Link& link) {
  return {Twin<T>::both(link[4]), Twin<T>::both(link[5]), Twin<T>::both(link[6]),
          Twin<T>::both(link[7]), Twin<T>::both(link[8]), Twin<T>::both(link[9])};
}

/// Computes tau = Y theta (n) by recursion, without forming Y. theta (13 n) need not be physically valid.
template <typename T>
void slotine_li_torque(const ChainT<T>& chain, const PosesT<T>& poses, const SlotineLiT<T>& s,
                       const ParameterVectorT<T>& theta, JointVectorT<T>& tau) {
  const T zero(0);
  const Twin<T> half = Twin<T>::both(T(0.5));
  TwinVec3T<T> F = TwinVec3T<T>::zero();  // (f, t)
  tau.resize(s.n);
  for (int i = s.n - 1; i >= 0; --i) {
    const auto k = static_cast<std::size_t>(i);
    const auto link = theta.template segment<kLinkParameters>(i * kLinkParameters);
    const Vec3T<T> h = link.template segment<3>(1);
    const TwinSymmetric3T<T> m_I = {{link[0], link[4]}, {zero, link[5]}, {zero, link[6]},
                                    {link[0], link[7]}, {zero, link[8]}, {link[0], link[9]}};
    const TwinVec3T<T>& E = s.acceleration[k];
    const Vec3T<T> w = s.velocity[k].second();
    const Vec3T<T> wr = s.reference[k].second();
    // (m e + a x h, I a + h x e)
    F += m_I * E + TwinVec3T<T>(E.second(), h).cross(TwinVec3T<T>(h, E.first()));
    // w x (wr x h) + wr x (w x h), w x (I wr) + wr x (I w). W holds w first, and W_r holds wr first.
    const TwinVec3T<T> W(w, wr);
    const TwinVec3T<T> W_r(wr, w);
    const TwinVec3T<T> forces = W.cross(W_r.cross(TwinVec3T<T>::both(h)));
    const TwinVec3T<T> moments = W.cross(inertia_twice<T>(link) * W_r);
    F += half * TwinVec3T<T>(forces.first() + forces.second(), moments.first() + moments.second());
    const auto joint = theta.template segment<kJointParameters>(joint_parameter_index(s.n, i));
    tau[i] = (chain.motion[k] == JointMotion::kRevolute ? F.z.second() : F.z.first()) + joint[0] * s.qddr[i] +
             joint[1] * s.qd[i] + joint[2] * s.coulomb[i];
    F = times(poses.R_PB[k], F);
    F.add_second(poses.p_PB[k].cross(F.first()));
  }
}

/// Returns the derivatives of body k's power (x_v . f + x_w . t) by its ten parameters, for a virtual motion
/// of the body with the linear velocity x_v and the angular velocity x_w.
template <typename T>
Eigen::Matrix<T, kLinkParameters, 1> link_power_gradient(const SlotineLiT<T>& s, std::size_t k,
                                                         const Vec3T<T>& x_v, const Vec3T<T>& x_w) {
  const Vec3T<T> w = s.velocity[k].second();
  const Vec3T<T> wr = s.reference[k].second();
  const Vec3T<T> e = s.acceleration[k].first();
  const Vec3T<T> a = s.acceleration[k].second();
  // Transposes of the maps from h: (a x h) . x = h . (x x a), (w x (wr x h)) . x = h . (wr x (w x x)).
  const Vec3T<T> moment =
      x_v.cross(a) + T(0.5) * (wr.cross(w.cross(x_v)) + w.cross(wr.cross(x_v))) + e.cross(x_w);
  // x_w . (I a) + ((x_w x w) . (I wr) + (x_w x wr) . (I w)) / 2 as coefficients of Ixx .. Izz.
  const Vec3T<T> b = T(0.5) * x_w.cross(w);
  const Vec3T<T> c = T(0.5) * x_w.cross(wr);
  const auto G = [&](int i, int j) { return x_w[i] * a[j] + b[i] * wr[j] + c[i] * w[j]; };
  Eigen::Matrix<T, kLinkParameters, 1> gradient;
  gradient << dot3(x_v, e), moment, G(0, 0), G(0, 1) + G(1, 0), G(0, 2) + G(2, 0), G(1, 1), G(1, 2) + G(2, 1),
      G(2, 2);
  return gradient;
}

/// Computes Y^T S (13 n). Y belongs to the motion `along`, and S = q' - qr' to the motion `s`; q is the same
/// for both. The body velocities for the joint velocities S are v - vr, so no further recursion is needed.
template <typename T>
void slotine_li_gradient(const SlotineLiT<T>& along, const SlotineLiT<T>& s, ParameterVectorT<T>& gradient) {
  gradient.resize(s.n * (kLinkParameters + kJointParameters));
  for (int i = 0; i < s.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const T S = s.qd[i] - s.qdr[i];
    gradient.template segment<kLinkParameters>(i * kLinkParameters) =
        link_power_gradient<T>(along, k, s.velocity[k].first() - s.reference[k].first(),
                               s.velocity[k].second() - s.reference[k].second());
    gradient.template segment<kJointParameters>(joint_parameter_index(s.n, i)) << S * along.qddr[i],
        S * along.qd[i], S * along.coulomb[i];
  }
}

/// Computes Y^T S (13 n), where both Y and S belong to the motion `s`.
template <typename T>
void slotine_li_gradient(const SlotineLiT<T>& s, ParameterVectorT<T>& gradient) {
  slotine_li_gradient(s, s, gradient);
}

/// Computes Y (n x 13 n) itself, for identification and tests.
template <typename T>
void slotine_li_regressor(const ChainT<T>& chain, const PosesT<T>& poses, const SlotineLiT<T>& s,
                          RegressorT<T>& Y) {
  Y.setZero(s.n, s.n * (kLinkParameters + kJointParameters));
  for (int j = 0; j < s.n; ++j) {
    // Motion of every body beyond joint j when only joint j moves, at unit speed.
    const bool revolute = chain.motion[static_cast<std::size_t>(j)] == JointMotion::kRevolute;
    Vec3T<T> x_v = revolute ? Vec3T<T>::Zero().eval() : Vec3T<T>::UnitZ().eval();
    Vec3T<T> x_w = revolute ? Vec3T<T>::UnitZ().eval() : Vec3T<T>::Zero().eval();
    for (int i = j; i < s.n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (i > j) {
        x_v = poses.R_PB[k].transpose() * (x_v + x_w.cross(poses.p_PB[k])).eval();
        x_w = (poses.R_PB[k].transpose() * x_w).eval();
      }
      Y.template block<1, kLinkParameters>(j, i * kLinkParameters) =
          link_power_gradient<T>(s, k, x_v, x_w).transpose();
    }
    Y.template block<1, kJointParameters>(j, joint_parameter_index(s.n, j)) << s.qddr[j], s.qd[j],
        s.coulomb[j];
  }
}

}  // namespace armtune::internal
