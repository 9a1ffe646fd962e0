#pragma once
// Tests whether a rigid body can have a given inertia, and finds the nearest inertia that a rigid body can
// have. armtune uses this to check the inertias that a URDF gives for its links.
//
// The inertia I of a body about its centre of mass is related to the second moments S of its mass:
//   S = integral of r r^T dm = (tr(I) / 2) E - I,   E: the 3 x 3 identity matrix.
// A rigid body with the inertia I exists if and only if S has no negative eigenvalue. For the principal
// moments of I this means that none is negative, and that none is larger than the sum of the other two. See
// Wensing, Kim and Slotine, Linear matrix inequalities for physically consistent inertial parameter
// identification, 2018.

#include "core/robot/chain.hpp"

namespace armtune::internal {

/// Returns the principal moments about the centre of mass, in ascending order [kg m^2]. The mass is positive.
Vec3 principal_moments(const LinkInertia& body);

/// True if a rigid body can have this inertia. The tolerance is 1e-4 of the largest principal moment, since
/// vendors round to five digits.
bool is_physical(const LinkInertia& body);

/// True if the body has inertia about the z axis of its frame, which is the axis of its joint.
bool has_inertia_about_axis(const LinkInertia& body);

/// Returns the body with the nearest inertia that a rigid body can have; mass and centre of mass are kept.
/// Nearest means the smallest change of S in the Frobenius norm. Every eigenvalue of the new S is at least a
/// thousandth of the largest one.
LinkInertia nearest_physical(const LinkInertia& body);

}  // namespace armtune::internal
