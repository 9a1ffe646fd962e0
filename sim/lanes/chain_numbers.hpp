#pragma once
// Lists all numbers of a kinematic chain (geometry, inertia, friction, gravity) in one fixed order. This
// order is used to copy the models of several arms into the SIMD registers that simulate these arms at the
// same time.

#include "core/robot/chain.hpp"

namespace armtune::internal {

/// Returns how many numbers describe an arm of n joints, at most. Each joint has 9 + 3 for its pose in the
/// parent body, 1 + 3 + 9 for its link's inertia, 3 for rotor inertia and friction, and a radius. The tool's
/// pose has 9 + 3, and gravity 3.
constexpr int chain_number_count(int n) {
  return 29 * n + 15;
}
inline constexpr int kMostChainNumbers = chain_number_count(kMaxJoints);

/// Calls f(number) for each number, in order. The joint vectors must have chain.n entries; link_radius may be
/// empty.
template <typename AnyChain, typename F>
void for_each_number(AnyChain& chain, F f) {
  const auto each = [&f](auto& block) {
    for (Eigen::Index i = 0; i < block.size(); ++i) f(block.data()[i]);
  };
  for (std::size_t k = 0; k < static_cast<std::size_t>(chain.n); ++k) {
    each(chain.R_PB0[k]);
    each(chain.p_PB0[k]);
    f(chain.link[k].mass);
    each(chain.link[k].first_moment);
    each(chain.link[k].inertia);
  }
  each(chain.rotor_inertia);
  each(chain.viscous_friction);
  each(chain.coulomb_friction);
  each(chain.link_radius);
  each(chain.R_BT);
  each(chain.p_BT);
  each(chain.gravity);
}

}  // namespace armtune::internal
