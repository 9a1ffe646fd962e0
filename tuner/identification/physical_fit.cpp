#include "tuner/identification/physical_fit.hpp"

#include <Eigen/Eigenvalues>

#include "armtune/error.hpp"
#include "tuner/identification/physical_cone.hpp"

namespace armtune::internal {
namespace {

/// An estimate is not believed beyond this share of a group's size: noise-free logs would ask for 1e12.
constexpr double kFinest = 1e-5;
/// An eigenvalue of a matrix of correlations is not negative by more than this.
constexpr double kRounding = 1e-6;

/// Weight matrix: inverse of the covariance, floored. Along what was not excited it is next to nothing, so
/// that the prior decides there.
Eigen::MatrixXd information(const BaseParameters& base, const Estimate& estimate,
                            const ParameterVector& prior) {
  const Eigen::VectorXd size = group_sizes(base, prior);
  Eigen::MatrixXd covariance = estimate.covariance;
  covariance.diagonal() += (kFinest * size).cwiseAbs2();
  // Deviations range from a millionth of a group's size to a hundred times it, so correlations are inverted.
  const Eigen::VectorXd unscale = covariance.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(unscale.asDiagonal() * covariance *
                                                             unscale.asDiagonal());
  if (!(eigen.eigenvalues().minCoeff() > -kRounding)) {
    throw InputError(
        "the full set of arm parameters (theta) cannot be computed, because the covariance of the estimate "
        "is not positive definite; log longer");
  }
  const Eigen::VectorXd inverse = eigen.eigenvalues().cwiseMax(kRounding * kRounding).cwiseInverse();
  return unscale.asDiagonal() * eigen.eigenvectors() * inverse.asDiagonal() *
         eigen.eigenvectors().transpose() * unscale.asDiagonal();
}

}  // namespace

PhysicalMinimum physical_fit(const BaseParameters& base, const Estimate& estimate,
                             const ParameterVector& prior) {
  const PhysicalCone cone(prior);
  // min (B theta - estimate)^T C (B theta - estimate) + |A (theta - prior)|^2
  const Eigen::MatrixXd C = information(base, estimate, prior);
  const Eigen::MatrixXd Q = base.map.transpose() * C * base.map + cone.metric();
  const Eigen::VectorXd c = base.map.transpose() * (C * estimate.theta) + cone.metric() * prior;
  PhysicalMinimum minimum = cone.minimum(Q, c, {});
  if (!minimum.theta.allFinite())
    throw InputError(
        "the full set of arm parameters (theta) cannot be computed, because the logged motion excites the "
        "arm too little; log more motion");
  return minimum;
}

}  // namespace armtune::internal
