#pragma once
// Converts a chain (chain.hpp) to another scalar type. With dual numbers (common/dual.hpp), the kinematics of
// the chain then have exact derivatives.

#include "core/robot/chain.hpp"

namespace armtune::internal {

template <typename T>
ChainT<T> chain_cast(const Chain& chain) {
  ChainT<T> to;
  to.n = chain.n;
  to.motion = chain.motion;
  for (std::size_t k = 0; k < static_cast<std::size_t>(chain.n); ++k) {
    to.R_PB0[k] = chain.R_PB0[k].template cast<T>();
    to.p_PB0[k] = chain.p_PB0[k].template cast<T>();
    to.link[k].mass = T(chain.link[k].mass);
    to.link[k].first_moment = chain.link[k].first_moment.template cast<T>();
    to.link[k].inertia = chain.link[k].inertia.template cast<T>();
  }
  to.rotor_inertia = chain.rotor_inertia.template cast<T>();
  to.viscous_friction = chain.viscous_friction.template cast<T>();
  to.coulomb_friction = chain.coulomb_friction.template cast<T>();
  to.link_radius = chain.link_radius.template cast<T>();
  to.R_BT = chain.R_BT.template cast<T>();
  to.p_BT = chain.p_BT.template cast<T>();
  to.gravity = chain.gravity.template cast<T>();
  return to;
}

}  // namespace armtune::internal
