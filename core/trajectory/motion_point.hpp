#pragma once
// Position, velocity and acceleration at one instant, for scalars and Cartesian points alike.

namespace armtune::internal {

template <typename V>
struct MotionPoint {
  V position{};
  V velocity{};
  V acceleration{};
};

}  // namespace armtune::internal
