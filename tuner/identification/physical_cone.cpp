#include "tuner/identification/physical_cone.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/robot/physical_theta.hpp"

namespace armtune::internal {
namespace {

/// Unit of length in the pseudo-inertia [m]. With it, a link's mass, first moment and inertia are of similar
/// size.
constexpr double kLength = 0.2;
/// Smallest eigenvalue of a pseudo-inertia, as a share of its trace in the prior. It keeps the link's mass
/// and inertia large enough for a simulator to divide by them.
constexpr double kLeastEigenvalue = 1e-9;
/// A relative distance from the valid set above this is more than a rounding error.
constexpr double kInvalid = 1e-6;

PseudoInertia scaled(const Eigen::Matrix<double, kLinkParameters, 1>& link) {
  const Eigen::Vector4d per_metre(1.0 / kLength, 1.0 / kLength, 1.0 / kLength, 1.0);
  return per_metre.asDiagonal() * pseudo_inertia(link) * per_metre.asDiagonal();
}

}  // namespace

PhysicalCone::PhysicalCone(const ParameterVector& prior) {
  const auto n = prior.size() / (kLinkParameters + kJointParameters);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto link = prior.segment<kLinkParameters>(i * kLinkParameters);
    link_unit_.push_back(std::max(1e-6, scaled(link).trace()));
  }
  const auto joints = prior.tail(n * kJointParameters);
  for (Eigen::Index k = 0; k < kJointParameters; ++k) {
    double largest = 0.0;
    for (Eigen::Index i = 0; i < n; ++i) largest = std::max(largest, joints[i * kJointParameters + k]);
    joint_unit_[static_cast<std::size_t>(k)] = largest > 0.0 ? largest : 1.0;
  }
  const Eigen::Index p = prior.size();
  map_.resize(n * (16 + kJointParameters), p);
  for (Eigen::Index k = 0; k < p; ++k) map_.col(k) = coordinates(Eigen::VectorXd::Unit(p, k));
  metric_ = map_.transpose() * map_;
}

Eigen::VectorXd PhysicalCone::coordinates(const Eigen::VectorXd& theta) const {
  const auto n = static_cast<Eigen::Index>(link_unit_.size());
  Eigen::VectorXd y(n * (16 + kJointParameters));
  for (Eigen::Index i = 0; i < n; ++i) {
    const PseudoInertia P =
        scaled(theta.segment<kLinkParameters>(i * kLinkParameters)) / link_unit_[static_cast<std::size_t>(i)];
    y.segment<16>(16 * i) = P.reshaped();
    for (Eigen::Index k = 0; k < kJointParameters; ++k) {
      y[16 * n + i * kJointParameters + k] =
          theta[n * kLinkParameters + i * kJointParameters + k] / joint_unit_[static_cast<std::size_t>(k)];
    }
  }
  return y;
}

ParameterVector PhysicalCone::theta_from(const Eigen::VectorXd& y) const {
  const auto n = static_cast<Eigen::Index>(link_unit_.size());
  ParameterVector theta(n * (kLinkParameters + kJointParameters));
  const Eigen::Vector4d metres(kLength, kLength, kLength, 1.0);
  for (Eigen::Index i = 0; i < n; ++i) {
    const PseudoInertia P =
        link_unit_[static_cast<std::size_t>(i)] *
        (metres.asDiagonal() * Eigen::Map<const PseudoInertia>(y.data() + 16 * i) * metres.asDiagonal());
    theta.segment<kLinkParameters>(i * kLinkParameters) = link_parameters(P);
    for (Eigen::Index k = 0; k < kJointParameters; ++k) {
      theta[n * kLinkParameters + i * kJointParameters + k] =
          y[16 * n + i * kJointParameters + k] * joint_unit_[static_cast<std::size_t>(k)];
    }
  }
  return theta;
}

/// Returns the nearest valid coordinates in the Euclidean norm. The eigenvalues of every pseudo-inertia
/// become at least `least_eigenvalue`.
Eigen::VectorXd PhysicalCone::project(const Eigen::VectorXd& y, double least_eigenvalue) const {
  Eigen::VectorXd valid = y;
  const auto n = static_cast<Eigen::Index>(link_unit_.size());
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

PhysicalMinimum PhysicalCone::minimum(const Eigen::MatrixXd& Q, const Eigen::VectorXd& c,
                                      const Accuracy& accuracy) const {
  Eigen::VectorXd y = coordinates(Q.llt().solve(c));
  Eigen::VectorXd z = project(y, kLeastEigenvalue);
  PhysicalMinimum found;
  found.changed = (y - project(y, 0.0)).norm() > kInvalid * (1.0 + y.norm());
  if (!found.changed) {
    found.theta = theta_from(z);
    return found;
  }
  // The initial penalty is chosen between the extreme eigenvalues of Q in these coordinates.
  double rho = std::sqrt(metric_.llt().matrixL().solve(Q).norm());
  Eigen::LLT<Eigen::MatrixXd> factor(Q + rho * metric_);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(y.size());
  for (int iteration = 0; iteration < accuracy.iterations; ++iteration) {
    y = map_ * factor.solve(c + rho * (map_.transpose() * (z - u)));
    const Eigen::VectorXd last = z;
    z = project(y + u, kLeastEigenvalue);
    u += y - z;
    const double primal = (y - z).norm();
    const double dual = (z - last).norm();
    if (std::max(primal, dual) < accuracy.tolerance * (1.0 + z.norm())) break;
    // Residual balancing (Boyd et al., section 3.4.1), rarely enough that the iteration still converges.
    if (iteration % 100 == 99 && (primal > 10.0 * dual || dual > 10.0 * primal)) {
      const double change = primal > dual ? 2.0 : 0.5;
      rho *= change;
      u /= change;
      factor.compute(Q + rho * metric_);
    }
  }
  found.theta = theta_from(z);
  return found;
}

}  // namespace armtune::internal
