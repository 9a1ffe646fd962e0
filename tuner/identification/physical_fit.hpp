#pragma once
// Completes base parameters to a whole theta that some arm could have. Of all physically valid theta
// (physical_theta.hpp) it is the one whose base parameters are nearest to the estimate in the metric of its
// covariance. Where the data determine nothing, theta stays near a prior. The problem is convex, a
// quadratic over cones (Sousa and Cortesao, Physical feasibility of robot base inertial parameter
// identification, 2014).

#include "tuner/identification/base_parameters.hpp"
#include "tuner/identification/physical_cone.hpp"
#include "tuner/identification/regression.hpp"

namespace armtune::internal {

/// Returns the fitted theta. prior (13 n), valid: the robot file's theta, weighted as if each link were known
/// within 100 %. Throws InputError if the covariance of the estimate is not positive definite, or if no
/// finite theta is found.
PhysicalMinimum physical_fit(const BaseParameters& base, const Estimate& estimate,
                             const ParameterVector& prior);

}  // namespace armtune::internal
