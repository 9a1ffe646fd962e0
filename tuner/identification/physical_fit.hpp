#pragma once
// Completes identified base parameters to theta, the full vector of inertial and friction parameters. Among
// all physically valid theta (physical_theta.hpp) it finds the one whose base parameters are nearest to the
// estimate, in the metric of the estimate's covariance. The problem is convex: a quadratic function is
// minimised over cones (Sousa and Cortesao, Physical feasibility of robot base inertial parameter
// identification, 2014).
//
// Where the data determine nothing, theta stays near a prior. If the estimate is not physically valid and
// some base parameters were not excited, theta may move farther from the estimate to come nearer to the
// prior. The squared distance may then double or, if that is more, rise by the number of base parameters.

#include "tuner/identification/base_parameters.hpp"
#include "tuner/identification/physical_cone.hpp"
#include "tuner/identification/regression.hpp"

namespace armtune::internal {

/// Returns the fitted theta. prior (13 n): the robot file's theta, which must be physically valid. It is
/// weighted as if the parameters of each link were known with a standard deviation of 100 %. Throws
/// InputError if the covariance of the estimate is not positive definite, or if no finite theta is found.
PhysicalMinimum physical_fit(const BaseParameters& base, const Estimate& estimate,
                             const ParameterVector& prior);

}  // namespace armtune::internal
