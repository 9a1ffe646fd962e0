#include "core/robot/physical_theta.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

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

void project_to_physical(ParameterVector& theta) {
  const auto n = theta.size() / (kLinkParameters + kJointParameters);
  for (Eigen::Index i = 0; i < n; ++i) {
    auto link = theta.segment<kLinkParameters>(i * kLinkParameters);
    const PseudoInertia P = pseudo_inertia(link);
    // Almost every theta is valid already, which a Cholesky factorisation sees twenty times faster.
    if (P.llt().info() == Eigen::Success) continue;
    const Eigen::SelfAdjointEigenSolver<PseudoInertia> eigen(P);
    const Eigen::Vector4d kept = eigen.eigenvalues().cwiseMax(0.0);
    link = link_parameters(eigen.eigenvectors() * kept.asDiagonal() * eigen.eigenvectors().transpose());
  }
  auto joints = theta.tail(n * kJointParameters);
  joints = joints.cwiseMax(0.0).eval();
}

}  // namespace armtune::internal
