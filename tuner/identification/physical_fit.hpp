#pragma once
// From base parameters to a whole theta that some arm could have: of all physically valid theta
// (physical_theta.hpp) the one whose base parameters are nearest to the estimate in the metric of its
// covariance; what the data leave open stays near a prior. A convex problem (a quadratic over cones; Sousa
// and Cortesao, Physical feasibility of robot base inertial parameter identification, 2014).

#include "tuner/identification/base_parameters.hpp"
#include "tuner/identification/physical_cone.hpp"
#include "tuner/identification/regression.hpp"

namespace armtune::internal {

/// prior (13 n), valid: the robot file's theta. Its weight is that of knowing each link within 100 %.
PhysicalMinimum physical_fit(const BaseParameters& base, const Estimate& estimate,
                             const ParameterVector& prior);

}  // namespace armtune::internal
