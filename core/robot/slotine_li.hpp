#pragma once
// The Slotine-Li regressor: Y(q, q', qr', qr'') theta = (M + D) qr'' + C(q, q') qr' + g + friction(q'),
// with the C for which M' - 2C is skew. Slotine and Li, On the adaptive control of robot manipulators, 1987;
// the recursion is Niemeyer and Slotine's (Performance in adaptive manipulator control, 1991).
//
// Force of one body, from  I (ar - v x vr / 2) + v x* (I vr) / 2 + vr x* (I v) / 2  in spatial notation with
// ar_i = X ar + S qr'' + v_i x S qr'. Multiplied out in 3-vectors, with v = (v, w) and
//   e = ar_linear + wr x v,     a = ar_angular - w x wr / 2,
// the first-moment terms collapse by Jacobi's identity to
//   f = m e + a x h + (w x (wr x h) + wr x (w x h)) / 2
//   t = h x e + I a + (w x (I wr) + wr x (I w)) / 2.

#include "core/robot/friction.hpp"
#include "core/robot/kinematics.hpp"
#include "core/robot/theta.hpp"

namespace armtune {

/// Motion of every body for one (q, q', qr', qr''); from it come Y theta, Y^T S and Y itself.
template <typename T>
struct SlotineLiT {
  int n = 0;
  std::array<Vec3T<T>, kMaxJoints> v{};   ///< linear velocity of the body origin, body frame
  std::array<Vec3T<T>, kMaxJoints> w{};   ///< angular velocity
  std::array<Vec3T<T>, kMaxJoints> vr{};  ///< reference velocities
  std::array<Vec3T<T>, kMaxJoints> wr{};
  std::array<Vec3T<T>, kMaxJoints> e{};  ///< effective linear acceleration, gravity included
  std::array<Vec3T<T>, kMaxJoints> a{};  ///< effective angular acceleration
  JointVectorT<T> qd;
  JointVectorT<T> qdr;
  JointVectorT<T> qddr;
  JointVectorT<T> coulomb;  ///< tanh(q'/0.05)
};
using SlotineLi = SlotineLiT<double>;

/// Forward recursion. qd: q' measured; qdr, qddr: references (n each).
template <typename T>
void slotine_li_forward(const ChainT<T>& chain, const PosesT<T>& poses, const JointVectorT<T>& qd,
                        const JointVectorT<T>& qdr, const JointVectorT<T>& qddr, SlotineLiT<T>& s) {
  s.n = chain.n;
  s.qd = qd;
  s.qdr = qdr;
  s.qddr = qddr;
  coulomb_directions(qd, s.coulomb);
  Vec3T<T> v = Vec3T<T>::Zero();
  Vec3T<T> w = Vec3T<T>::Zero();
  Vec3T<T> vr = Vec3T<T>::Zero();
  Vec3T<T> wr = Vec3T<T>::Zero();
  Vec3T<T> ar = -chain.gravity;  // spatial reference acceleration, linear part
  Vec3T<T> aw = Vec3T<T>::Zero();
  for (int i = 0; i < chain.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Mat3T<T>& R = poses.R_PB[k];
    const Vec3T<T>& p = poses.p_PB[k];
    v = R.transpose() * (v + w.cross(p)).eval();
    w = (R.transpose() * w).eval();
    vr = R.transpose() * (vr + wr.cross(p)).eval();
    wr = (R.transpose() * wr).eval();
    ar = R.transpose() * (ar + aw.cross(p)).eval();
    aw = (R.transpose() * aw).eval();
    // v_i x S qr' with S along z (the velocity's own S q' part drops out of it).
    if (chain.motion[k] == JointMotion::kRevolute) {
      ar += Vec3T<T>(v.y(), -v.x(), T(0)) * qdr[i];
      aw += Vec3T<T>(w.y() * qdr[i], -w.x() * qdr[i], qddr[i]);
      w.z() += qd[i];
      wr.z() += qdr[i];
    } else {
      ar += Vec3T<T>(w.y() * qdr[i], -w.x() * qdr[i], qddr[i]);
      v.z() += qd[i];
      vr.z() += qdr[i];
    }
    s.v[k] = v;
    s.w[k] = w;
    s.vr[k] = vr;
    s.wr[k] = wr;
    s.e[k] = ar + wr.cross(v);
    s.a[k] = aw - T(0.5) * w.cross(wr);
  }
}

/// tau = Y theta (n), by recursion, without forming Y. theta (13 n) need not be physically valid.
template <typename T>
void slotine_li_torque(const ChainT<T>& chain, const PosesT<T>& poses, const SlotineLiT<T>& s,
                       const ParameterVectorT<T>& theta, JointVectorT<T>& tau) {
  Vec3T<T> f = Vec3T<T>::Zero();
  Vec3T<T> t = Vec3T<T>::Zero();
  tau.resize(s.n);
  for (int i = s.n - 1; i >= 0; --i) {
    const auto k = static_cast<std::size_t>(i);
    const auto link = theta.template segment<kLinkParameters>(i * kLinkParameters);
    const Vec3T<T> h = link.template segment<3>(1);
    Mat3T<T> I;
    I << link[4], link[5], link[6], link[5], link[7], link[8], link[6], link[8], link[9];
    const Vec3T<T>& w = s.w[k];
    const Vec3T<T>& wr = s.wr[k];
    f += link[0] * s.e[k] + s.a[k].cross(h) + T(0.5) * (w.cross(wr.cross(h)) + wr.cross(w.cross(h)));
    t += h.cross(s.e[k]) + I * s.a[k] + T(0.5) * (w.cross(I * wr) + wr.cross(I * w));
    const auto joint = theta.template segment<kJointParameters>(joint_parameter_index(s.n, i));
    tau[i] = (chain.motion[k] == JointMotion::kRevolute ? t.z() : f.z()) + joint[0] * s.qddr[i] +
             joint[1] * s.qd[i] + joint[2] * s.coulomb[i];
    f = (poses.R_PB[k] * f).eval();
    t = (poses.R_PB[k] * t).eval() + poses.p_PB[k].cross(f);
  }
}

/// Derivatives of the power (x_v . f + x_w . t) of body k by its ten parameters, for a virtual body motion x.
template <typename T>
Eigen::Matrix<T, kLinkParameters, 1> link_power_gradient(const SlotineLiT<T>& s, std::size_t k,
                                                         const Vec3T<T>& x_v, const Vec3T<T>& x_w) {
  const Vec3T<T>& w = s.w[k];
  const Vec3T<T>& wr = s.wr[k];
  const Vec3T<T>& e = s.e[k];
  const Vec3T<T>& a = s.a[k];
  // Transposes of the maps from h: (a x h) . x = h . (x x a), (w x (wr x h)) . x = h . (wr x (w x x)).
  const Vec3T<T> moment =
      x_v.cross(a) + T(0.5) * (wr.cross(w.cross(x_v)) + w.cross(wr.cross(x_v))) + e.cross(x_w);
  // x_w . (I a) + ((x_w x w) . (I wr) + (x_w x wr) . (I w)) / 2 as coefficients of Ixx .. Izz.
  const Vec3T<T> b = T(0.5) * x_w.cross(w);
  const Vec3T<T> c = T(0.5) * x_w.cross(wr);
  const Mat3T<T> G = x_w * a.transpose() + b * wr.transpose() + c * w.transpose();
  Eigen::Matrix<T, kLinkParameters, 1> gradient;
  gradient << x_v.dot(e), moment, G(0, 0), G(0, 1) + G(1, 0), G(0, 2) + G(2, 0), G(1, 1), G(1, 2) + G(2, 1),
      G(2, 2);
  return gradient;
}

/// Y^T S (13 n) with S = q' - qr': the body motions of S are v - vr, so no further recursion is needed.
template <typename T>
void slotine_li_gradient(const SlotineLiT<T>& s, ParameterVectorT<T>& gradient) {
  gradient.resize(s.n * (kLinkParameters + kJointParameters));
  for (int i = 0; i < s.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const T S = s.qd[i] - s.qdr[i];
    gradient.template segment<kLinkParameters>(i * kLinkParameters) =
        link_power_gradient<T>(s, k, s.v[k] - s.vr[k], s.w[k] - s.wr[k]);
    gradient.template segment<kJointParameters>(joint_parameter_index(s.n, i)) << S * s.qddr[i], S * s.qd[i],
        S * s.coulomb[i];
  }
}

/// Y (n x 13 n) itself, for identification and tests.
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

}  // namespace armtune
