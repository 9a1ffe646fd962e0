#pragma once
// Completes identified base parameters to theta, the full vector of inertial and friction parameters. Among
// all physically valid theta (physical_theta.hpp) it finds the one whose base parameters are nearest to the
// estimate, in the metric of the estimate's covariance. The problem is convex, a quadratic over cones (Sousa
// and Cortesao, Physical feasibility of robot base inertial parameter identification, 2014).
//
// Where the data determine nothing, theta stays near a prior. If some base parameters were not excited, theta
// may be farther from the estimate if that brings it nearer to the prior: the squared distance may double, or
// rise by one for each base parameter.

#include "tuner/identification/base_parameters.hpp"
#include "tuner/identification/physical_cone.hpp"
#include "tuner/identification/regression.hpp"

namespace armtune::internal {

/// Returns the fitted theta. prior (13 n), valid: the robot file's theta, weighted as if the parameters of
/// each link were known with a standard deviation of 100 %. Throws InputError if the covariance of the
/// estimate is not positive definite, or if no finite theta is found.
PhysicalMinimum physical_fit(const BaseParameters& base, const Estimate& estimate,
                             const ParameterVector& prior);

}  // namespace armtune::internal
