#pragma once
// Makes the perturbed copies of a gain set from whose rollouts derivatives are computed.

#include <Eigen/Core>
#include <vector>

#include "tuner/derivatives/metric_derivative.hpp"
#include "tuner/study/parameter.hpp"

namespace armtune::internal {

/// A copy of the gain set in which one search coordinate is changed.
struct PerturbedCopy {
  int gain = 0;
  bool second = false;  ///< it has the step 2h
  double step = 0.0;    ///< change of the coordinate
  Gains gains;
};

/// Returns the copies of the gains at x, one for each coordinate, or two with options.two_steps. Both steps
/// of a coordinate go up, or both down where 1 is too near.
std::vector<PerturbedCopy> perturbed_copies(const ParameterSpace& space, const std::vector<double>& x,
                                            const DerivativeOptions& options);

/// Returns dx_i / dgain_i for all coordinates.
Eigen::VectorXd coordinates_per_gain(const ParameterSpace& space, const std::vector<double>& x);

}  // namespace armtune::internal
