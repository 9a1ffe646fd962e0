#pragma once
// Tests whether an inertia is physically possible for a rigid body, and finds the nearest one that is. It
// checks the inertias that a URDF gives for its links.
//
// The inertia I of a body about its centre of mass follows from the second moments of its mass,
// S = integral of r r^T dm = tr(I)/2 1 - I. A body exists for every S without negative eigenvalues. In
// principal moments this means: none is negative, and none is larger than the sum of the other two. See
// Wensing, Kim and Slotine, Linear matrix inequalities for physically consistent inertial parameter
// identification, 2018.

#include "core/robot/chain.hpp"

namespace armtune::internal {

/// Returns the principal moments about the centre of mass, in ascending order [kg m^2]. The mass is positive.
Vec3 principal_moments(const LinkInertia& body);

/// True if a rigid body can have this inertia. The tolerance is 1e-4 of the largest moment, since vendors
/// round to five digits.
bool is_physical(const LinkInertia& body);

/// Returns the body's mass and centre with the nearest inertia that a rigid body can have: nearest in the
/// Frobenius norm of S, with at least a thousandth of the largest second moment along every axis.
LinkInertia nearest_physical(const LinkInertia& body);

}  // namespace armtune::internal
