#pragma once
// Conditional choices that work both for a single number and for several numbers side by side
// (core/common/pack.hpp). Several numbers may need different branches of an `if`. The code therefore computes
// both results and selects one for each number.

#include <type_traits>

namespace armtune::internal {

/// Returns a where the condition is true, else b.
template <typename T>
T select(bool where, const T& a, const T& b) {
  return where ? a : b;
}

/// True if a condition holds for at least one number (any), or for every number (all). The condition is a
/// bool for a single number, and a mask for several numbers.
inline bool any(bool where) {
  return where;
}
inline bool all(bool where) {
  return where;
}
template <typename Mask, std::enable_if_t<!std::is_same_v<Mask, bool>, int> = 0>
bool any(const Mask& where) {
  constexpr auto kLanes = static_cast<int>(sizeof(Mask) / sizeof(where[0]));
  auto some = where[0];
  for (int lane = 1; lane < kLanes; ++lane) some |= where[lane];
  return some != 0;
}
template <typename Mask, std::enable_if_t<!std::is_same_v<Mask, bool>, int> = 0>
bool all(const Mask& where) {
  return !any(~where);
}

/// The result type of comparing two T.
template <typename T>
using MaskT = decltype(T(0) < T(0));

}  // namespace armtune::internal
