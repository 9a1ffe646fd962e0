#pragma once
// Position, velocity and acceleration at one instant, of a scalar or of a vector such as a Cartesian point.

namespace armtune::internal {

template <typename V>
struct MotionPoint {
  V position{};
  V velocity{};
  V acceleration{};
};

}  // namespace armtune::internal
