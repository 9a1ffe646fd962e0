#include "tuner/identification/physical_fit.hpp"

#include <Eigen/Cholesky>

#include "core/common/error.hpp"
#include "tuner/identification/physical_cone.hpp"

namespace armtune {
namespace {

/// An estimate is not believed beyond this share of a group's size: noise-free logs would ask for 1e12.
constexpr double kFinest = 1e-5;
/// Standard deviation along a direction that the logs do not excite, as a multiple of its size.
constexpr double kUnknown = 1e3;

/// Weight matrix: inverse of the covariance, floored. Along what was not excited it is next to nothing, so
/// that the prior decides there.
Eigen::MatrixXd information(const BaseParameters& base, const Estimate& estimate,
                            const ParameterVector& prior) {
  const Eigen::Index rank = base.rank();
  // A group's size: what its members' sizes add up to.
  const Eigen::VectorXd size = base.map.cwiseAbs() * prior.cwiseAbs() + Eigen::VectorXd::Constant(rank, 1e-6);
  Eigen::MatrixXd covariance = estimate.covariance;
  for (Eigen::Index k = 0; k < estimate.open_directions.cols(); ++k) {
    const Eigen::VectorXd direction = estimate.open_directions.col(k);
    // As long as the first of the groups that it moves is large.
    const double length = (direction.cwiseAbs().cwiseQuotient(size)).maxCoeff();
    covariance += (kUnknown / length * direction) * (kUnknown / length * direction).transpose();
  }
  covariance.diagonal() += (kFinest * size).cwiseAbs2();
  const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
  if (factor.info() != Eigen::Success) {
    throw InputError(
        "theta cannot be completed, because the covariance of the estimate is not positive definite; log "
        "longer");
  }
  return factor.solve(Eigen::MatrixXd::Identity(rank, rank));
}

}  // namespace

PhysicalMinimum physical_fit(const BaseParameters& base, const Estimate& estimate,
                             const ParameterVector& prior) {
  const PhysicalCone cone(prior);
  // min (B theta - estimate)^T C (B theta - estimate) + |A (theta - prior)|^2
  const Eigen::MatrixXd C = information(base, estimate, prior);
  const Eigen::MatrixXd Q = base.map.transpose() * C * base.map + cone.metric();
  const Eigen::VectorXd c = base.map.transpose() * (C * estimate.theta) + cone.metric() * prior;
  return cone.minimum(Q, c, {});
}

}  // namespace armtune
