#pragma once
// Moves parameters theta (theta.hpp) to the nearest ones that are physically possible. The adaptive control
// law can use this to keep its estimate of theta possible. The condition is that the pseudo-inertia P of
// every link is positive semi-definite,
//   P = [Sigma h; h^T m],   Sigma = (tr(I) / 2) E - I,   h = m c,
// with the identity matrix E (3 x 3), the link's mass m, centre of mass c, and inertia I about the origin of
// its frame. A distribution of mass with these ten parameters exists if and only if the condition holds
// (Wensing, Kim and Slotine, Linear matrix inequalities for physically consistent inertial parameter
// identification, 2018). Rotor inertia and friction must not be negative.

#include "core/robot/theta.hpp"

namespace armtune::internal {

using PseudoInertia = Eigen::Matrix4d;

/// Converts one link's ten parameters to P, and back.
PseudoInertia pseudo_inertia(const Eigen::Matrix<double, kLinkParameters, 1>& link);
Eigen::Matrix<double, kLinkParameters, 1> link_parameters(const PseudoInertia& P);

/// Changes theta (13 n) to the nearest physically valid one. Nearest means the smallest change of each P in
/// the Frobenius norm. The parameters of a link whose P is positive definite stay bit-identical. If P is only
/// semi-definite, as for a point mass, they stay the same within rounding. Allocates nothing.
void project_to_physical(ParameterVector& theta);

}  // namespace armtune::internal
