#pragma once
// Moves parameters theta (theta.hpp) to the nearest ones that are physically possible. The adaptive control
// law can use this to keep its estimate of theta possible. The condition is that the pseudo-inertia P of
// every link is positive semi-definite,
//   P = [Sigma h; h^T m],   Sigma = (tr(I) / 2) E - I,   h = m c,
// with the identity matrix E (3 x 3), the link's mass m, centre of mass c, and inertia I about the origin of
// its frame. A distribution of mass with these ten parameters exists if and only if the condition holds
// (Wensing, Kim and Slotine, Linear matrix inequalities for physically consistent inertial parameter
// identification, 2018). Rotor inertia and friction must not be negative.

#include "core/common/select.hpp"
#include "core/robot/theta.hpp"

namespace armtune::internal {

template <typename T>
using LinkParametersT = Eigen::Matrix<T, kLinkParameters, 1>;
using LinkParameters = LinkParametersT<double>;
template <typename T>
using PseudoInertiaT = Eigen::Matrix<T, 4, 4>;
using PseudoInertia = PseudoInertiaT<double>;

/// Converts one link's ten parameters to P, and back. Here and below, the scalar type T is double for one
/// arm, or a SIMD type for several arms at once (core/common/pack.hpp).
template <typename T>
PseudoInertiaT<T> pseudo_inertia(const LinkParametersT<T>& link) {
  const T& Ixx = link[4];
  const T& Ixy = link[5];
  const T& Ixz = link[6];
  const T& Iyy = link[7];
  const T& Iyz = link[8];
  const T& Izz = link[9];
  const T half(0.5);
  PseudoInertiaT<T> P;
  P << half * (Iyy + Izz - Ixx), -Ixy, -Ixz, link[1],  //
      -Ixy, half * (Ixx + Izz - Iyy), -Iyz, link[2],   //
      -Ixz, -Iyz, half * (Ixx + Iyy - Izz), link[3],   //
      link[1], link[2], link[3], link[0];
  return P;
}
PseudoInertia pseudo_inertia(const LinkParameters& link);
LinkParameters link_parameters(const PseudoInertia& P);

/// Returns where every eigenvalue of P is positive, that is, where every pivot of Gaussian elimination is.
template <typename T>
MaskT<T> positive_definite(PseudoInertiaT<T> P) {
  const T zero(0.0);
  MaskT<T> positive = P(0, 0) > zero;
  for (int k = 0; k < 3; ++k) {
    const T inverse = T(1.0) / P(k, k);
    for (int i = k + 1; i < 4; ++i) {
      const T factor = P(i, k) * inverse;
      for (int j = k + 1; j <= i; ++j) P(i, j) -= factor * P(j, k);
    }
    positive = positive & (P(k + 1, k + 1) > zero);
  }
  return positive;
}

/// Returns x where it is not negative, else 0.
template <typename T>
T not_negative(const T& x) {
  return select(x < T(0.0), T(0.0), x);
}

/// Changes a link's ten parameters to the nearest physically valid ones. P must not be positive definite.
void make_physical(LinkParameters& link);

/// Changes theta (13 n) to the nearest physically valid one. Nearest means the smallest change of each P in
/// the Frobenius norm. The parameters of a link whose P is positive definite stay bit-identical. If P is only
/// semi-definite, as for a point mass, they stay the same within rounding. Allocates nothing.
void project_to_physical(ParameterVector& theta);

}  // namespace armtune::internal
