#include "tuner/identification/physical_fit.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "armtune/error.hpp"
#include "tuner/identification/physical_cone.hpp"

namespace armtune::internal {
namespace {

/// Smallest standard deviation of a base parameter that is believed, as a share of the parameter's size.
/// Without this floor, noise-free logs would give weights of 1e12.
constexpr double kFinest = 1e-5;
/// Rounding makes an eigenvalue of a correlation matrix negative by no more than this.
constexpr double kEigenRounding = 1e-6;
/// Largest number of times that the weight of the prior is doubled. Its standard deviation is then about 1 %.
constexpr int kDoublings = 13;

/// Returns the weight matrix of the estimate: the inverse of its covariance, with a floor on the standard
/// deviations. Along directions that were not excited it is nearly zero, so that the prior decides there.
Eigen::MatrixXd information(const BaseParameters& base, const Estimate& estimate,
                            const ParameterVector& prior) {
  const Eigen::VectorXd size = group_sizes(base, prior);
  Eigen::MatrixXd covariance = estimate.covariance;
  covariance.diagonal() += (kFinest * size).cwiseAbs2();
  // Standard deviations range from a millionth of a base parameter's size to a hundred times its size.
  // Therefore the correlation matrix is inverted, not the covariance.
  const Eigen::VectorXd unscale = covariance.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(unscale.asDiagonal() * covariance *
                                                             unscale.asDiagonal());
  if (!(eigen.eigenvalues().minCoeff() > -kEigenRounding)) {
    throw InputError(
        "the full set of arm parameters (theta) cannot be computed, because the covariance of the estimate "
        "is not positive definite; log longer");
  }
  const Eigen::VectorXd inverse =
      eigen.eigenvalues().cwiseMax(kEigenRounding * kEigenRounding).cwiseInverse();
  return unscale.asDiagonal() * eigen.eigenvectors() * inverse.asDiagonal() *
         eigen.eigenvectors().transpose() * unscale.asDiagonal();
}

/// Minimises (B theta - estimate)^T C (B theta - estimate) + |A (theta - prior)|^2.
class Fit {
 public:
  Fit(const BaseParameters& base, const Estimate& estimate, const ParameterVector& prior)
      : base_(base),
        estimate_(estimate),
        prior_(prior),
        cone_(prior),
        information_(information(base, estimate, prior)),
        seen_(base.map.transpose() * information_ * base.map),
        wanted_(base.map.transpose() * (information_ * estimate.theta)) {}

  /// strength: factor on the prior's weight for the links.
  PhysicalMinimum minimum(double strength) const {
    Eigen::MatrixXd weight = cone_.metric();
    const Eigen::Index links = prior_.size() / (kLinkParameters + kJointParameters) * kLinkParameters;
    weight.topLeftCorner(links, links) *= strength;
    return cone_.minimum(seen_ + weight, wanted_ + weight * prior_, {});
  }

  /// Returns the squared distance from the estimate, in units of the estimate's standard deviations.
  double distance(const ParameterVector& theta) const {
    const Eigen::VectorXd off = base_.map * theta - estimate_.theta;
    return off.dot(information_ * off);
  }

 private:
  const BaseParameters& base_;
  const Estimate& estimate_;
  const ParameterVector& prior_;
  PhysicalCone cone_;
  Eigen::MatrixXd information_;
  Eigen::MatrixXd seen_;
  Eigen::VectorXd wanted_;
};

}  // namespace

PhysicalMinimum physical_fit(const BaseParameters& base, const Estimate& estimate,
                             const ParameterVector& prior) {
  const Fit fit(base, estimate, prior);
  PhysicalMinimum minimum = fit.minimum(1.0);
  if (!minimum.theta.allFinite())
    throw InputError(
        "the full set of arm parameters (theta) cannot be computed, because the logged motion excites the "
        "arm too little; log more motion");
  if (!minimum.changed || estimate.not_excited.empty()) return minimum;
  // Parameters that were not excited are held by the weak prior alone. The step into the valid set could
  // change them by any amount, only to save a fraction of a standard deviation elsewhere. The prior is
  // therefore strengthened as long as the fit stays near the estimate. Noise in the positions makes the
  // stated standard deviations too small. The smallest distance is then large itself, so the limit is
  // relative to it.
  const double nearest = fit.distance(minimum.theta);
  const double allowed = nearest + std::max(nearest, static_cast<double>(base.rank()));
  for (int doublings = 1; doublings <= kDoublings; ++doublings) {
    const PhysicalMinimum nearer = fit.minimum(std::exp2(doublings));
    if (!nearer.theta.allFinite() || fit.distance(nearer.theta) > allowed) break;
    minimum.theta = nearer.theta;
  }
  return minimum;
}

}  // namespace armtune::internal
