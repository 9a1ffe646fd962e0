#pragma once
// Exact derivatives of the inverse dynamics (dynamics.hpp) with respect to q, q' and q''. The motion planner
// needs them for its torque limits. The method is that of Singh, Russell and Wensing, Efficient analytical
// derivatives of rigid-body dynamics using spatial vector algebra, RA-L 2022. Spatial vectors are (angular,
// linear), about the base frame's origin and with its axes: Featherstone, Rigid Body Dynamics Algorithms,
// chapter 2.

#include "core/robot/friction.hpp"
#include "core/robot/kinematics.hpp"

namespace armtune::internal {

/// The torque tau of `inverse_dynamics` (n) and its derivatives by q, q' and q'' (n x n each).
template <typename T>
struct InverseDynamicsDerivativesT {
  JointVectorT<T> tau;     ///< [N m, N]
  JointMatrixT<T> by_q;    ///< [unit of tau per rad or m]
  JointMatrixT<T> by_qd;   ///< [unit of tau per rad/s or m/s]
  JointMatrixT<T> by_qdd;  ///< M + D
};
using InverseDynamicsDerivatives = InverseDynamicsDerivativesT<double>;

namespace spatial {

template <typename T>
using Matrix = Eigen::Matrix<T, 6, 6>;

template <typename T>
Mat3T<T> skew(const Vec3T<T>& a) {
  Mat3T<T> S;
  S << T(0), -a.z(), a.y(), a.z(), T(0), -a.x(), -a.y(), a.x(), T(0);
  return S;
}

/// Returns the spatial cross product v x m of two motion vectors.
template <typename T>
Vec6T<T> cross(const Vec6T<T>& v, const Vec6T<T>& m) {
  const Vec3T<T> w = v.template head<3>();
  Vec6T<T> result;
  result.template head<3>() = w.cross(m.template head<3>());
  result.template tail<3>() =
      w.cross(m.template tail<3>()) + v.template tail<3>().cross(m.template head<3>());
  return result;
}

/// Returns the spatial cross product v x* f of a motion vector v and a force vector f = (moment, force).
template <typename T>
Vec6T<T> cross_force(const Vec6T<T>& v, const Vec6T<T>& f) {
  const Vec3T<T> w = v.template head<3>();
  Vec6T<T> result;
  result.template head<3>() =
      w.cross(f.template head<3>()) + v.template tail<3>().cross(f.template tail<3>());
  result.template tail<3>() = w.cross(f.template tail<3>());
  return result;
}

/// Returns the spatial inertia of a body about the base frame's origin. R_0B, p_0B: pose of the body.
template <typename T>
Matrix<T> inertia(const LinkInertiaT<T>& link, const Mat3T<T>& R_0B, const Vec3T<T>& p_0B) {
  const Vec3T<T> h = R_0B * link.first_moment;
  const Mat3T<T> P = skew<T>(p_0B);
  const Mat3T<T> H = skew<T>(h);
  Matrix<T> I;
  I.template topLeftCorner<3, 3>() =
      R_0B * link.inertia * R_0B.transpose() - P * H - H * P - link.mass * P * P;
  I.template topRightCorner<3, 3>() = H + link.mass * P;
  I.template bottomLeftCorner<3, 3>() = -I.template topRightCorner<3, 3>();
  I.template bottomRightCorner<3, 3>() = link.mass * Mat3T<T>::Identity();
  return I;
}

/// Returns 2 B(I, v) = (v x*) I - I (v x) + (I v) x*-bar, where (f x*-bar) m = m x* f for every motion vector
/// m. B maps the motion of a joint to the change of the velocity-product forces on the bodies beyond it.
template <typename T>
Matrix<T> twice_B(const Matrix<T>& I, const Vec6T<T>& v) {
  const Mat3T<T> W = skew<T>(v.template head<3>());
  const Mat3T<T> V = skew<T>(v.template tail<3>());
  Matrix<T> motion;
  motion << W, Mat3T<T>::Zero(), V, W;
  const Vec6T<T> momentum = I * v;
  const Mat3T<T> N = skew<T>(momentum.template head<3>());
  const Mat3T<T> F = skew<T>(momentum.template tail<3>());
  Matrix<T> result = -motion.transpose() * I - I * motion;  // v x* = -(v x)^T
  result.template topLeftCorner<3, 3>() -= N;
  result.template topRightCorner<3, 3>() -= F;
  result.template bottomLeftCorner<3, 3>() -= F;
  return result;
}

/// A joint, and the body that it moves.
template <typename T>
struct MovedBody {
  Vec6T<T> S;         ///< motion of the joint at unit velocity
  Vec6T<T> S_rate;    ///< v_parent x S: change of the velocity along q
  Vec6T<T> S_rate_2;  ///< a_parent x S + v_parent x (v_parent x S)
  Vec6T<T> f;         ///< force on the body; later also on all bodies beyond it, as I and B2
  Matrix<T> I;
  Matrix<T> B2;
};
template <typename T>
using MovedBodies = std::array<MovedBody<T>, kMaxJoints>;

/// Computes the motion of every joint and body, from the base outwards, and the force on each body alone.
template <typename T>
void compute_motion(const ChainT<T>& chain, const PosesT<T>& poses, const JointVectorT<T>& qd,
                    const JointVectorT<T>& qdd, MovedBodies<T>& bodies) {
  Vec6T<T> v = Vec6T<T>::Zero();
  Vec6T<T> a;
  a << Vec3T<T>::Zero(), -chain.gravity;
  for (int i = 0; i < chain.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    MovedBody<T>& body = bodies[k];
    const Vec3T<T> z = poses.R_0B[k].col(2);
    if (chain.motion[k] == JointMotion::kRevolute) {
      body.S << z, poses.p_0B[k].cross(z);
    } else {
      body.S << Vec3T<T>::Zero(), z;
    }
    body.S_rate = cross<T>(v, body.S);
    body.S_rate_2 = cross<T>(a, body.S) + cross<T>(v, body.S_rate);
    v += body.S * qd[i];
    a += body.S * qdd[i] + body.S_rate * qd[i];
    body.I = inertia<T>(chain.link[k], poses.R_0B[k], poses.p_0B[k]);
    body.B2 = twice_B<T>(body.I, v);
    body.f = body.I * a + cross_force<T>(v, Vec6T<T>(body.I * v));
  }
}

/// Writes row i and column i of the derivatives, up to the diagonal, without friction and rotors. bodies[i]
/// must contain the sums over the body itself and the bodies beyond it.
template <typename T>
void write_derivatives(const MovedBodies<T>& bodies, int i, InverseDynamicsDerivativesT<T>& out) {
  const MovedBody<T>& body = bodies[static_cast<std::size_t>(i)];
  // Change of the forces on the bodies beyond joint i, along the motion of joint i.
  const Vec6T<T> own_rate = Vec6T<T>(T(2) * body.S_rate);  // v_i x S_i = v_parent x S_i
  const Vec6T<T> along_q = body.B2 * body.S_rate + body.I * body.S_rate_2 + cross_force<T>(body.S, body.f);
  const Vec6T<T> along_qd = body.B2 * body.S + body.I * own_rate;
  const Vec6T<T> along_qdd = body.I * body.S;
  // The same matrix, multiplied from the left: change of joint i's torque along the joints before it.
  const Vec6T<T> left_B = body.B2.transpose() * body.S;
  for (int j = 0; j <= i; ++j) {
    const MovedBody<T>& before = bodies[static_cast<std::size_t>(j)];
    out.by_q(j, i) = before.S.dot(along_q);
    out.by_qd(j, i) = before.S.dot(along_qd);
    out.by_qdd(j, i) = out.by_qdd(i, j) = before.S.dot(along_qdd);
    if (j == i) continue;
    out.by_q(i, j) = left_B.dot(before.S_rate) + along_qdd.dot(before.S_rate_2);
    out.by_qd(i, j) = left_B.dot(before.S) + T(2) * along_qdd.dot(before.S_rate);
  }
}

}  // namespace spatial

/// Computes tau and its derivatives. qd: q' (n) [rad/s, m/s]. qdd: q'' (n) [rad/s^2, m/s^2]. poses: from
/// `forward_kinematics` at q.
template <typename T>
void inverse_dynamics_derivatives(const ChainT<T>& chain, const PosesT<T>& poses, const JointVectorT<T>& qd,
                                  const JointVectorT<T>& qdd, InverseDynamicsDerivativesT<T>& out) {
  const int n = chain.n;
  spatial::MovedBodies<T> bodies;
  spatial::compute_motion<T>(chain, poses, qd, qdd, bodies);
  out.tau.resize(n);
  out.by_q.resize(n, n);
  out.by_qd.resize(n, n);
  out.by_qdd.resize(n, n);
  for (int i = n - 1; i >= 0; --i) {
    const auto k = static_cast<std::size_t>(i);
    const spatial::MovedBody<T>& body = bodies[k];
    const T direction = coulomb_direction(qd[i]);
    out.tau[i] = body.S.dot(body.f) + chain.rotor_inertia[i] * qdd[i] + chain.viscous_friction[i] * qd[i] +
                 chain.coulomb_friction[i] * direction;
    spatial::write_derivatives<T>(bodies, i, out);
    out.by_qd(i, i) += chain.viscous_friction[i] +
                       chain.coulomb_friction[i] * (T(1) - direction * direction) / T(kCoulombVelocity);
    out.by_qdd(i, i) += chain.rotor_inertia[i];
    if (i > 0) {
      spatial::MovedBody<T>& parent = bodies[k - 1];
      parent.f += body.f;
      parent.I += body.I;
      parent.B2 += body.B2;
    }
  }
}

}  // namespace armtune::internal
