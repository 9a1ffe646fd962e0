#pragma once
// The numbers of a chain, listed in one order for every scalar type.

#include "core/robot/chain.hpp"

namespace armtune::internal {

/// Returns the largest count of numbers for n joints. Each joint has 9 + 3 of its place, 1 + 3 + 9 of its
/// link, 3 of the joint and a radius. The tool has 9 + 3 and gravity 3.
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
