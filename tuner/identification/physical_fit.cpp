#include "tuner/identification/physical_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/common/error.hpp"
#include "core/robot/physical_theta.hpp"

namespace armtune {
namespace {

/// In the pseudo-inertia lengths count in this unit [m], so that a link's mass, first moment and inertia are
/// of one size.
constexpr double kLength = 0.2;
/// An estimate is not believed beyond this share of a group's size: noise-free logs would ask for 1e12.
constexpr double kFinest = 1e-5;
/// Least eigenvalue of a pseudo-inertia, as a share of the prior's trace: a link keeps a mass and an inertia
/// that a simulator can divide by.
constexpr double kLeastEigenvalue = 1e-9;
/// Farther than this from valid, relative, is more than rounding.
constexpr double kInvalid = 1e-6;
constexpr int kMostIterations = 20000;
constexpr double kConverged = 1e-10;

/// theta in coordinates in which the Frobenius norm of every scaled pseudo-inertia is the Euclidean one.
class Coordinates {
 public:
  explicit Coordinates(const ParameterVector& prior) : scale_(prior.size()) {
    const auto n = prior.size() / (kLinkParameters + kJointParameters);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto link = prior.segment<kLinkParameters>(i * kLinkParameters);
      unit_.push_back(std::max(1e-6, scaled(link).trace()));
    }
    // Of rotor inertia and friction: as large as the arm's largest, or 1 where the robot file knows none.
    const auto joints = prior.tail(n * kJointParameters);
    for (Eigen::Index k = 0; k < kJointParameters; ++k) {
      double largest = 0.0;
      for (Eigen::Index i = 0; i < n; ++i) largest = std::max(largest, joints[i * kJointParameters + k]);
      joint_unit_[static_cast<std::size_t>(k)] = largest > 0.0 ? largest : 1.0;
    }
  }

  /// Linear map theta -> coordinates (16 per link, 3 per joint).
  Eigen::VectorXd to(const Eigen::VectorXd& theta) const {
    const auto n = static_cast<Eigen::Index>(unit_.size());
    Eigen::VectorXd y(n * (16 + kJointParameters));
    for (Eigen::Index i = 0; i < n; ++i) {
      const PseudoInertia P =
          scaled(theta.segment<kLinkParameters>(i * kLinkParameters)) / unit_[static_cast<std::size_t>(i)];
      y.segment<16>(16 * i) = P.reshaped();
      for (Eigen::Index k = 0; k < kJointParameters; ++k) {
        y[16 * n + i * kJointParameters + k] =
            theta[n * kLinkParameters + i * kJointParameters + k] / joint_unit_[static_cast<std::size_t>(k)];
      }
    }
    return y;
  }

  /// Nearest valid theta in the norm of the coordinates, as coordinates; inside the cone by that
  /// eigenvalue.
  Eigen::VectorXd project(const Eigen::VectorXd& y, double least_eigenvalue = kLeastEigenvalue) const {
    Eigen::VectorXd valid = y;
    const auto n = static_cast<Eigen::Index>(unit_.size());
    ParameterVector link = ParameterVector::Zero(kLinkParameters + kJointParameters);
    for (Eigen::Index i = 0; i < n; ++i) {
      const PseudoInertia least = least_eigenvalue * PseudoInertia::Identity();
      const PseudoInertia P = Eigen::Map<const PseudoInertia>(y.data() + 16 * i);
      link.head<kLinkParameters>() = link_parameters(P - least);
      project_to_physical(link);
      valid.segment<16>(16 * i) = (pseudo_inertia(link.head<kLinkParameters>()) + least).reshaped();
    }
    valid.tail(n * kJointParameters) = valid.tail(n * kJointParameters).cwiseMax(0.0);
    return valid;
  }

  ParameterVector from(const Eigen::VectorXd& y) const {
    const auto n = static_cast<Eigen::Index>(unit_.size());
    ParameterVector theta(n * (kLinkParameters + kJointParameters));
    const Eigen::Vector4d metres(kLength, kLength, kLength, 1.0);
    for (Eigen::Index i = 0; i < n; ++i) {
      const PseudoInertia P =
          unit_[static_cast<std::size_t>(i)] *
          (metres.asDiagonal() * Eigen::Map<const PseudoInertia>(y.data() + 16 * i) * metres.asDiagonal());
      theta.segment<kLinkParameters>(i * kLinkParameters) = link_parameters(P);
      for (Eigen::Index k = 0; k < kJointParameters; ++k) {
        theta[n * kLinkParameters + i * kJointParameters + k] =
            y[16 * n + i * kJointParameters + k] * joint_unit_[static_cast<std::size_t>(k)];
      }
    }
    return theta;
  }

 private:
  static PseudoInertia scaled(const Eigen::Matrix<double, kLinkParameters, 1>& link) {
    const Eigen::Vector4d per_metre(1.0 / kLength, 1.0 / kLength, 1.0 / kLength, 1.0);
    return per_metre.asDiagonal() * pseudo_inertia(link) * per_metre.asDiagonal();
  }

  Eigen::VectorXd scale_;
  std::vector<double> unit_;
  std::array<double, kJointParameters> joint_unit_{};
};

/// Weight matrix: inverse of the covariance, floored, without groups that were not excited.
Eigen::MatrixXd information(const BaseParameters& base, const Estimate& estimate,
                            const ParameterVector& prior) {
  const Eigen::Index rank = base.rank();
  // A group's size: what its members' sizes add up to.
  const Eigen::VectorXd size = base.map.cwiseAbs() * prior.cwiseAbs() + Eigen::VectorXd::Constant(rank, 1e-6);
  Eigen::MatrixXd covariance = estimate.covariance;
  for (const int dead : estimate.not_excited) {
    covariance.row(dead).setZero();
    covariance.col(dead).setZero();
    covariance(dead, dead) = 1e6 * size[dead] * size[dead];
  }
  covariance.diagonal() += (kFinest * size).cwiseAbs2();
  const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
  if (factor.info() != Eigen::Success) {
    throw InputError(
        "theta cannot be completed: the estimate's covariance is not positive definite; log longer");
  }
  return factor.solve(Eigen::MatrixXd::Identity(rank, rank));
}

}  // namespace

PhysicalFit physical_fit(const BaseParameters& base, const Estimate& estimate, const ParameterVector& prior) {
  const Coordinates coordinates(prior);
  const Eigen::Index p = prior.size();
  const Eigen::VectorXd prior_y = coordinates.to(prior);
  Eigen::MatrixXd A(prior_y.size(), p);
  for (Eigen::Index k = 0; k < p; ++k) A.col(k) = coordinates.to(Eigen::VectorXd::Unit(p, k));
  const Eigen::MatrixXd AtA = A.transpose() * A;

  // min (B theta - estimate)^T C (B theta - estimate) + |A (theta - prior)|^2
  const Eigen::MatrixXd C = information(base, estimate, prior);
  const Eigen::MatrixXd Q = base.map.transpose() * C * base.map + AtA;
  const Eigen::VectorXd c = base.map.transpose() * (C * estimate.theta) + AtA * prior;
  const Eigen::VectorXd unconstrained = Q.llt().solve(c);

  PhysicalFit fit;
  Eigen::VectorXd y = coordinates.to(unconstrained);
  Eigen::VectorXd z = coordinates.project(y);
  fit.changed = (y - coordinates.project(y, 0.0)).norm() > kInvalid * (1.0 + y.norm());
  if (!fit.changed) {
    fit.theta = coordinates.from(z);
    return fit;
  }
  // The penalty between the extremes of Q in these coordinates.
  const Eigen::MatrixXd whitened = AtA.llt().matrixL().solve(Q);
  double rho = std::sqrt(whitened.norm());
  Eigen::LLT<Eigen::MatrixXd> factor(Q + rho * AtA);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(y.size());
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    const Eigen::VectorXd theta = factor.solve(c + rho * (A.transpose() * (z - u)));
    y = A * theta;
    const Eigen::VectorXd last = z;
    z = coordinates.project(y + u);
    u += y - z;
    const double primal = (y - z).norm();
    const double dual = (z - last).norm();
    if (std::max(primal, dual) < kConverged * (1.0 + z.norm())) break;
    // Residual balancing (Boyd et al., section 3.4.1), seldom enough to converge.
    if (iteration % 100 == 99 && (primal > 10.0 * dual || dual > 10.0 * primal)) {
      const double change = primal > dual ? 2.0 : 0.5;
      rho *= change;
      u /= change;
      factor.compute(Q + rho * AtA);
    }
  }
  fit.theta = coordinates.from(z);
  return fit;
}

}  // namespace armtune
