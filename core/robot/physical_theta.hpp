#pragma once
// Physically valid theta: of every link the pseudo-inertia
//   P = [Sigma h; h^T m],   Sigma = tr(I)/2 1 - I,   h = m c,
// is positive semi-definite, exactly if some distribution of mass has these ten parameters (Wensing, Kim and
// Slotine, Linear matrix inequalities for physically consistent inertial parameter identification, 2018);
// rotor inertia and friction are not negative.

#include "core/robot/theta.hpp"

namespace armtune::internal {

using PseudoInertia = Eigen::Matrix4d;

/// P of one link's ten parameters, and back.
PseudoInertia pseudo_inertia(const Eigen::Matrix<double, kLinkParameters, 1>& link);
Eigen::Matrix<double, kLinkParameters, 1> link_parameters(const PseudoInertia& P);

/// Moves theta (13 n) to the nearest physically valid one: nearest in the Frobenius norm of each P. A link
/// whose P is positive definite stays as it is, to the bit; one at the edge, such as a point mass, stays
/// within rounding. Allocates nothing.
void project_to_physical(ParameterVector& theta);

}  // namespace armtune::internal
