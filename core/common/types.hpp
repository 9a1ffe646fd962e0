#pragma once
// Vector and matrix types of fixed capacity, for arms with up to kMaxJoints joints. Their sizes are set at
// run time, but their capacity is fixed at compile time, so they never allocate.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace armtune::internal {

/// Largest number of joints of a serial arm. The memory of every workspace is laid out for it.
inline constexpr int kMaxJoints = 12;
/// Inertial parameters per link: mass, first moment (3), inertia about the joint frame (6).
inline constexpr int kLinkParameters = 10;
/// Parameters per joint: rotor inertia, viscous friction, Coulomb friction.
inline constexpr int kJointParameters = 3;
inline constexpr int kMaxParameters = kMaxJoints * (kLinkParameters + kJointParameters);

template <typename T>
using Vec3T = Eigen::Matrix<T, 3, 1>;
template <typename T>
using Mat3T = Eigen::Matrix<T, 3, 3>;
template <typename T>
using Vec6T = Eigen::Matrix<T, 6, 1>;
/// One entry per joint (n).
template <typename T>
using JointVectorT = Eigen::Matrix<T, Eigen::Dynamic, 1, 0, kMaxJoints, 1>;
/// n x n.
template <typename T>
using JointMatrixT = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxJoints, kMaxJoints>;
/// 6 x n, rows (linear, angular).
template <typename T>
using JacobianT = Eigen::Matrix<T, 6, Eigen::Dynamic, 0, 6, kMaxJoints>;
/// theta: 13 n entries, see core/robot/theta.hpp for their order.
template <typename T>
using ParameterVectorT = Eigen::Matrix<T, Eigen::Dynamic, 1, 0, kMaxParameters, 1>;
/// n x 13 n.
template <typename T>
using RegressorT =
    Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMaxJoints, kMaxParameters>;

using Vec3 = Vec3T<double>;
using Mat3 = Mat3T<double>;
using Vec6 = Vec6T<double>;
using JointVector = JointVectorT<double>;
using JointMatrix = JointMatrixT<double>;
using Jacobian = JacobianT<double>;
using ParameterVector = ParameterVectorT<double>;
using Regressor = RegressorT<double>;

}  // namespace armtune::internal
