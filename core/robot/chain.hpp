#pragma once
// A serial chain of joints, described by its geometry, inertia and friction, without names and limits. The
// kinematics, the dynamics and the control laws use it. The scalar type T is double for one arm. With a SIMD
// type (common/pack.hpp) the same code computes several arms at once.

#include <array>

#include "core/common/types.hpp"

namespace armtune::internal {

enum class JointMotion { kRevolute, kPrismatic };

/// Inertia of one link about the origin of its body frame, in that frame.
template <typename T>
struct LinkInertiaT {
  T mass = T(0);                             ///< [kg]
  Vec3T<T> first_moment = Vec3T<T>::Zero();  ///< m c [kg m]
  Mat3T<T> inertia = Mat3T<T>::Zero();       ///< about the body frame's origin [kg m^2]
};
using LinkInertia = LinkInertiaT<double>;

/// A serial chain of n joints. The body frame B of every joint has its origin on the joint's axis and z along
/// the axis: a joint turns about, or slides along, its own z. `R_PB0`, `p_PB0`: pose of B in the previous
/// body's frame P at q = 0. The first P is the base frame 0.
template <typename T>
struct ChainT {
  int n = 0;
  std::array<JointMotion, kMaxJoints> motion{};
  std::array<Mat3T<T>, kMaxJoints> R_PB0{};
  std::array<Vec3T<T>, kMaxJoints> p_PB0{};
  std::array<LinkInertiaT<T>, kMaxJoints> link{};
  JointVectorT<T> rotor_inertia;     ///< D, reflected to the joint [kg m^2, kg]
  JointVectorT<T> viscous_friction;  ///< [N m s/rad, N s/m]
  JointVectorT<T> coulomb_friction;  ///< [N m, N]
  /// Radii of the links [m], for their distance from obstacles. If empty, the distance of the joints' origins
  /// is used instead.
  JointVectorT<T> link_radius;
  Mat3T<T> R_BT = Mat3T<T>::Identity();  ///< pose of the tool frame T in the last body frame
  Vec3T<T> p_BT = Vec3T<T>::Zero();
  Vec3T<T> gravity = Vec3T<T>(T(0), T(0), T(-9.81));  ///< in the base frame [m/s^2]
};
using Chain = ChainT<double>;

}  // namespace armtune::internal
