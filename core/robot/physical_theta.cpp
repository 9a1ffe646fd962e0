#include "core/robot/physical_theta.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace armtune::internal {

PseudoInertia pseudo_inertia(const LinkParameters& link) {
  return pseudo_inertia<double>(link);
}

LinkParameters link_parameters(const PseudoInertia& P) {
  LinkParameters link;
  link << P(3, 3), P(0, 3), P(1, 3), P(2, 3), P(1, 1) + P(2, 2), -P(0, 1), -P(0, 2), P(0, 0) + P(2, 2),
      -P(1, 2), P(0, 0) + P(1, 1);
  return link;
}

namespace {

/// Lifts the negative eigenvalue of P to zero if P has exactly one and inverse iteration finds it. Otherwise
/// returns false. An adapting theta often stays at the boundary of possible values for long, where this takes
/// a fifth of the time of an eigendecomposition.
bool lift_one(PseudoInertia& P) {
  constexpr int kSteps = 6;          // each cubes the error
  constexpr double kAtRest = 1e-14;  // residual of an eigenvector, relative to P: rounding
  const double size = P.cwiseAbs().maxCoeff();
  Eigen::Vector4d v = Eigen::Vector4d::Constant(0.5);
  double eigenvalue = 0.0;  // so that the first step finds the eigenvalue nearest to zero
  double residual = size;
  for (int step = 0; step < kSteps && residual > kAtRest * size; ++step) {
    v = ((P - eigenvalue * PseudoInertia::Identity()).inverse() * v).normalized();
    const Eigen::Vector4d image = P * v;
    eigenvalue = v.dot(image);
    residual = (image - eigenvalue * v).norm();
  }
  if (!(residual <= kAtRest * size && eigenvalue < 0.0)) return false;
  // With this eigenvalue raised far above zero, all are positive exactly if the other three are.
  if (!positive_definite<double>(P + (size - eigenvalue) * v * v.transpose())) return false;
  P -= eigenvalue * v * v.transpose();
  return true;
}

/// Returns P with its negative eigenvalues set to zero.
PseudoInertia lifted(const PseudoInertia& P) {
  const Eigen::SelfAdjointEigenSolver<PseudoInertia> eigen(P);
  const Eigen::Vector4d kept = eigen.eigenvalues().cwiseMax(0.0);
  return eigen.eigenvectors() * kept.asDiagonal() * eigen.eigenvectors().transpose();
}

}  // namespace

void make_physical(LinkParameters& link) {
  PseudoInertia P = pseudo_inertia(link);
  link = link_parameters(lift_one(P) ? P : lifted(P));
}

void project_to_physical(ParameterVector& theta) {
  const auto n = theta.size() / (kLinkParameters + kJointParameters);
  for (Eigen::Index i = 0; i < n; ++i) {
    LinkParameters link = theta.segment<kLinkParameters>(i * kLinkParameters);
    if (positive_definite(pseudo_inertia(link))) continue;  // almost always
    make_physical(link);
    theta.segment<kLinkParameters>(i * kLinkParameters) = link;
  }
  for (double& x : theta.tail(n * kJointParameters)) x = not_negative(x);
}

}  // namespace armtune::internal
