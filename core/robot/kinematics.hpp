#pragma once
// Computes the forward kinematics of every joint, and the geometric Jacobian of the tool with its exact time
// derivative (Siciliano et al., Robotics: Modelling, Planning and Control, chapters 2 and 3). Frame 0 is the
// base.

#include "core/common/joint_math.hpp"
#include "core/common/products.hpp"
#include "core/robot/chain.hpp"
#include "core/robot/twin_vectors.hpp"

namespace armtune::internal {

/// The poses of an arm at one configuration. `forward_kinematics` computes them once in a control period, for
/// all code that needs a pose.
template <typename T>
struct PosesT {
  int n = 0;
  std::array<Mat3T<T>, kMaxJoints> R_PB{};  ///< pose of each body in the previous body's frame
  std::array<Vec3T<T>, kMaxJoints> p_PB{};
  std::array<Mat3T<T>, kMaxJoints> R_0B{};  ///< orientation of each body in the base frame
  std::array<Vec3T<T>, kMaxJoints> p_0B{};  ///< joint origins in the base frame [m]
  Mat3T<T> R_0T = Mat3T<T>::Identity();     ///< pose of the tool in the base frame
  Vec3T<T> p_0T = Vec3T<T>::Zero();
};
using Poses = PosesT<double>;

/// Computes the pose of every body in the previous body's frame at q (n) [rad, m]. The other members of
/// `poses` do not change.
template <typename T>
void relative_poses(const ChainT<T>& chain, const JointVectorT<T>& q, PosesT<T>& poses) {
  JointVectorT<T> sines;
  JointVectorT<T> cosines;
  sines_and_cosines(q, sines, cosines);
  poses.n = chain.n;
  for (int i = 0; i < chain.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (chain.motion[k] == JointMotion::kRevolute) {
      const T& c = cosines[i];
      const T& s = sines[i];
      const Mat3T<T>& R = chain.R_PB0[k];
      poses.R_PB[k].col(0) = R.col(0) * c + R.col(1) * s;
      poses.R_PB[k].col(1) = R.col(1) * c - R.col(0) * s;
      poses.R_PB[k].col(2) = R.col(2);
      poses.p_PB[k] = chain.p_PB0[k];
    } else {
      poses.R_PB[k] = chain.R_PB0[k];
      poses.p_PB[k] = chain.p_PB0[k] + chain.R_PB0[k].col(2) * q[i];
    }
  }
}

/// Computes the poses of all bodies at q (n) [rad, m], but not that of the tool.
template <typename T>
void body_poses(const ChainT<T>& chain, const JointVectorT<T>& q, PosesT<T>& poses) {
  relative_poses(chain, q, poses);
  poses.R_0B[0] = poses.R_PB[0];
  poses.p_0B[0] = poses.p_PB[0];
  for (int i = 1; i < chain.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Mat3T<T>& R = poses.R_PB[k];
    const TwinVec3T<T> xy = times(poses.R_0B[k - 1], TwinVec3T<T>(R.col(0), R.col(1)));
    const TwinVec3T<T> z_p = times(poses.R_0B[k - 1], TwinVec3T<T>(R.col(2), poses.p_PB[k]));
    poses.R_0B[k].col(0) = xy.first();
    poses.R_0B[k].col(1) = xy.second();
    poses.R_0B[k].col(2) = z_p.first();
    poses.p_0B[k] = poses.p_0B[k - 1] + z_p.second();
  }
}

/// Computes the poses of all bodies and of the tool at q (n) [rad, m].
template <typename T>
void forward_kinematics(const ChainT<T>& chain, const JointVectorT<T>& q, PosesT<T>& poses) {
  body_poses(chain, q, poses);
  const auto last = static_cast<std::size_t>(chain.n - 1);
  poses.R_0T = times(poses.R_0B[last], chain.R_BT);
  poses.p_0T = poses.p_0B[last] + times(poses.R_0B[last], chain.p_BT);
}

/// Computes the geometric Jacobian J (6 x n, linear rows first) of a point that is fixed in `body`. p_0: the
/// point in the base frame. Columns of joints beyond the body are zero.
template <typename T>
void point_jacobian(const ChainT<T>& chain, const PosesT<T>& poses, int body, const Vec3T<T>& p_0,
                    JacobianT<T>& J) {
  J.resize(6, chain.n);
  J.rightCols(chain.n - 1 - body).setZero();
  for (int i = 0; i <= body; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Vec3T<T> z = poses.R_0B[k].col(2);
    if (chain.motion[k] == JointMotion::kRevolute) {
      J.col(i).template head<3>() = z.cross(p_0 - poses.p_0B[k]);
      J.col(i).template tail<3>() = z;
    } else {
      J.col(i).template head<3>() = z;
      J.col(i).template tail<3>().setZero();
    }
  }
}

/// Computes J at the tool: (v_0T, w_0T) = J q'.
template <typename T>
void tool_jacobian(const ChainT<T>& chain, const PosesT<T>& poses, JacobianT<T>& J) {
  point_jacobian(chain, poses, chain.n - 1, poses.p_0T, J);
}

/// Computes the exact time derivative J' (6 x n) of the tool's Jacobian at the joint velocities qd = q'.
/// twist: J q'. The column of a revolute joint i is d/dt (z x (p_T - p_i), z). There z' = w x z, where w is
/// the angular velocity of the body before the joint.
template <typename T>
void tool_jacobian_derivative(const ChainT<T>& chain, const PosesT<T>& poses, const Vec6T<T>& twist,
                              const JointVectorT<T>& qd, JacobianT<T>& J_dot) {
  J_dot.resize(6, chain.n);
  const Vec3T<T> v_T = twist.template head<3>();
  Vec3T<T> w = Vec3T<T>::Zero();  // angular velocity of the body before joint i
  Vec3T<T> v = Vec3T<T>::Zero();  // velocity of that body's origin
  Vec3T<T> p = Vec3T<T>::Zero();  // that origin
  for (int i = 0; i < chain.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Vec3T<T> z = poses.R_0B[k].col(2);
    const Vec3T<T> z_dot = w.cross(z);
    v += w.cross(poses.p_0B[k] - p);
    if (chain.motion[k] == JointMotion::kRevolute) {
      J_dot.col(i).template head<3>() = z_dot.cross(poses.p_0T - poses.p_0B[k]) + z.cross(v_T - v);
      J_dot.col(i).template tail<3>() = z_dot;
      w += z * qd[i];
    } else {
      J_dot.col(i).template head<3>() = z_dot;
      J_dot.col(i).template tail<3>().setZero();
      v += z * qd[i];
    }
    p = poses.p_0B[k];
  }
}
template <typename T>
void tool_jacobian_derivative(const ChainT<T>& chain, const PosesT<T>& poses, const JacobianT<T>& J,
                              const JointVectorT<T>& qd, JacobianT<T>& J_dot) {
  tool_jacobian_derivative(chain, poses, times(J, qd), qd, J_dot);
}

}  // namespace armtune::internal
