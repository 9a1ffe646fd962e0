#pragma once
// Expresses the inertia of a link in the axes of another frame, about the same origin. The forward dynamics
// need the inertia of every link in the axes of the base.

#include "core/robot/chain.hpp"
#include "core/robot/twin_vectors.hpp"

namespace armtune::internal {

template <typename T>
struct TurnedLinkT {
  T mass;                    ///< [kg]
  Vec3T<T> first_moment;     ///< m c [kg m]
  T xx, xy, xz, yy, yz, zz;  ///< entries of the inertia [kg m^2]

  Vec3T<T> inertia_times(const Vec3T<T>& w) const {
    return {xx * w[0] + xy * w[1] + xz * w[2], xy * w[0] + yy * w[1] + yz * w[2],
            xz * w[0] + yz * w[1] + zz * w[2]};
  }
};

/// Returns (m, R h, R I R^T). R: orientation of the link's frame in the other frame. The code uses the upper
/// two rows of R together, as a twin.
template <typename T>
[[gnu::always_inline]] inline TurnedLinkT<T> turned(const LinkInertiaT<T>& link, const Mat3T<T>& R) {
  const Mat3T<T>& I = link.inertia;
  const Vec3T<T>& h = link.first_moment;
  const TwinVec3T<T> upper({R(0, 0), R(1, 0)}, {R(0, 1), R(1, 1)}, {R(0, 2), R(1, 2)});
  const Vec3T<T> lower(R(2, 0), R(2, 1), R(2, 2));
  const TwinVec3T<T> I_upper(upper.x * I(0, 0) + upper.y * I(0, 1) + upper.z * I(0, 2),
                             upper.x * I(0, 1) + upper.y * I(1, 1) + upper.z * I(1, 2),
                             upper.x * I(0, 2) + upper.y * I(1, 2) + upper.z * I(2, 2));
  const Vec3T<T> I_lower(I(0, 0) * lower[0] + I(0, 1) * lower[1] + I(0, 2) * lower[2],
                         I(0, 1) * lower[0] + I(1, 1) * lower[1] + I(1, 2) * lower[2],
                         I(0, 2) * lower[0] + I(1, 2) * lower[1] + I(2, 2) * lower[2]);
  const Twin<T> diagonal = upper.dot(I_upper);
  const Twin<T> right = upper.x * I_lower[0] + upper.y * I_lower[1] + upper.z * I_lower[2];
  const Twin<T> h_upper = upper.x * h[0] + upper.y * h[1] + upper.z * h[2];
  return {link.mass,        Vec3T<T>(h_upper.first(), h_upper.second(), dot3(lower, h)),
          diagonal.first(), dot3(upper.first(), I_upper.second()),
          right.first(),    diagonal.second(),
          right.second(),   dot3(lower, I_lower)};
}

}  // namespace armtune::internal
