#pragma once
// The vector theta of an arm's inertial and friction parameters, and the order of its entries. The equations
// of motion are linear in theta, so that adaptation and identification can estimate it.
//
// It has ten entries per link, link by link, in the link's body frame B (z along the joint axis), with the
// inertia about B's origin:
//   m, m cx, m cy, m cz, Ixx, Ixy, Ixz, Iyy, Iyz, Izz
// Three entries per joint follow, joint by joint: rotor inertia, viscous friction, Coulomb friction.

#include "core/robot/chain.hpp"

namespace armtune::internal {

/// Index of the first inertia entry in a link's ten parameters.
inline constexpr int kFirstInertia = 4;

/// Returns the index of a joint's first parameter (rotor inertia).
constexpr int joint_parameter_index(int n, int joint) {
  return n * kLinkParameters + joint * kJointParameters;
}

template <typename T>
constexpr int parameter_count(const ChainT<T>& chain) {
  return chain.n * (kLinkParameters + kJointParameters);
}

/// Returns theta of a chain (13 n entries).
template <typename T>
ParameterVectorT<T> theta_of(const ChainT<T>& chain) {
  ParameterVectorT<T> theta(parameter_count(chain));
  for (int i = 0; i < chain.n; ++i) {
    const auto& link = chain.link[static_cast<std::size_t>(i)];
    const auto& I = link.inertia;
    theta.template segment<kLinkParameters>(i * kLinkParameters) << link.mass, link.first_moment, I(0, 0),
        I(0, 1), I(0, 2), I(1, 1), I(1, 2), I(2, 2);
    theta.template segment<kJointParameters>(joint_parameter_index(chain.n, i)) << chain.rotor_inertia[i],
        chain.viscous_friction[i], chain.coulomb_friction[i];
  }
  return theta;
}

}  // namespace armtune::internal
