#pragma once
// The condition for physically possible parameters theta (theta.hpp), and the projection onto it. The
// adaptive control law can keep its estimate of theta possible with it. The pseudo-inertia of every link,
//   P = [Sigma h; h^T m],   Sigma = tr(I)/2 1 - I,   h = m c,
// must be positive semi-definite. This holds exactly if some distribution of mass has these ten parameters
// (Wensing, Kim and Slotine, Linear matrix inequalities for physically consistent inertial parameter
// identification, 2018). Rotor inertia and friction must not be negative.

#include "core/robot/theta.hpp"

namespace armtune::internal {

using PseudoInertia = Eigen::Matrix4d;

/// Converts one link's ten parameters to P, and back.
PseudoInertia pseudo_inertia(const Eigen::Matrix<double, kLinkParameters, 1>& link);
Eigen::Matrix<double, kLinkParameters, 1> link_parameters(const PseudoInertia& P);

/// Moves theta (13 n) to the nearest physically valid one, nearest in the Frobenius norm of each P. A link
/// whose P is positive definite stays bit-identical. One at the edge, such as a point mass, stays the same
/// within rounding. Allocates nothing.
void project_to_physical(ParameterVector& theta);

}  // namespace armtune::internal
