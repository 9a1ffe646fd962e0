#include "core/robot/physical_theta.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace armtune::internal {

PseudoInertia pseudo_inertia(const Eigen::Matrix<double, kLinkParameters, 1>& link) {
  const double Ixx = link[4];
  const double Ixy = link[5];
  const double Ixz = link[6];
  const double Iyy = link[7];
  const double Iyz = link[8];
  const double Izz = link[9];
  PseudoInertia P;
  P << 0.5 * (Iyy + Izz - Ixx), -Ixy, -Ixz, link[1],  //
      -Ixy, 0.5 * (Ixx + Izz - Iyy), -Iyz, link[2],   //
      -Ixz, -Iyz, 0.5 * (Ixx + Iyy - Izz), link[3],   //
      link[1], link[2], link[3], link[0];
  return P;
}

Eigen::Matrix<double, kLinkParameters, 1> link_parameters(const PseudoInertia& P) {
  Eigen::Matrix<double, kLinkParameters, 1> link;
  link << P(3, 3), P(0, 3), P(1, 3), P(2, 3), P(1, 1) + P(2, 2), -P(0, 1), -P(0, 2), P(0, 0) + P(2, 2),
      -P(1, 2), P(0, 0) + P(1, 1);
  return link;
}

namespace {

/// Returns true if every eigenvalue is positive, that is, if every pivot of Gaussian elimination is.
bool positive_definite(PseudoInertia P) {
  for (int k = 0; k < 4; ++k) {
    if (!(P(k, k) > 0.0)) return false;
    const double inverse = 1.0 / P(k, k);
    for (int i = k + 1; i < 4; ++i) {
      const double factor = P(i, k) * inverse;
      for (int j = k + 1; j <= i; ++j) P(i, j) -= factor * P(j, k);
    }
  }
  return true;
}

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
  if (!positive_definite(P + (size - eigenvalue) * v * v.transpose())) return false;
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

void project_to_physical(ParameterVector& theta) {
  const auto n = theta.size() / (kLinkParameters + kJointParameters);
  for (Eigen::Index i = 0; i < n; ++i) {
    auto link = theta.segment<kLinkParameters>(i * kLinkParameters);
    PseudoInertia P = pseudo_inertia(link);
    if (positive_definite(P)) continue;  // almost always
    link = link_parameters(lift_one(P) ? P : lifted(P));
  }
  auto joints = theta.tail(n * kJointParameters);
  joints = joints.cwiseMax(0.0).eval();
}

}  // namespace armtune::internal
