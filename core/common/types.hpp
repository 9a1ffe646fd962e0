#pragma once
// Vector and matrix types of fixed capacity, for arms with up to kMaxJoints joints. Their sizes are set at
// run time, but their capacity is fixed at compile time, so they never allocate.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace armtune::internal {

/// Largest number of joints of a serial arm. Every workspace reserves memory for this number.
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
/// A vector with one entry per joint (n).
template <typename T>
using JointVectorT = Eigen::Matrix<T, Eigen::Dynamic, 1, 0, kMaxJoints, 1>;
/// An n x n matrix, such as the mass matrix.
template <typename T>
using JointMatrixT = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxJoints, kMaxJoints>;
/// A 6 x n Jacobian with the linear rows first, then the angular rows.
template <typename T>
using JacobianT = Eigen::Matrix<T, 6, Eigen::Dynamic, 0, 6, kMaxJoints>;
/// The parameter vector theta: 13 n entries, whose order is given in core/robot/theta.hpp.
template <typename T>
using ParameterVectorT = Eigen::Matrix<T, Eigen::Dynamic, 1, 0, kMaxParameters, 1>;
/// The regressor Y (n x 13 n), see core/robot/slotine_li.hpp.
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
