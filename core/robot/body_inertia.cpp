#include "core/robot/body_inertia.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

constexpr double kTolerance = 1e-4;  // share of the largest principal moment; for files with five digits
constexpr double kThinnest = 1e-3;   // smallest second moment, as a share of the largest

/// Returns the inertia about the body's origin of a point mass at the centre of mass (Steiner's theorem).
Mat3 of_center(const LinkInertia& body) {
  const Vec3 c = body.first_moment / body.mass;
  return body.mass * (c.squaredNorm() * Mat3::Identity() - c * c.transpose());
}

}  // namespace

Vec3 principal_moments(const LinkInertia& body) {
  return Eigen::SelfAdjointEigenSolver<Mat3>(body.inertia - of_center(body), Eigen::EigenvaluesOnly)
      .eigenvalues();
}

bool is_physical(const LinkInertia& body) {
  const Vec3 moments = principal_moments(body);
  // The second term covers the rounding of the subtraction: the moments of a point mass are zero.
  const double slack = kTolerance * std::abs(moments[2]) + 1e-12 * body.inertia.norm();
  return moments[0] >= -slack && moments[0] + moments[1] >= moments[2] - slack;
}

bool has_inertia_about_axis(const LinkInertia& body) {
  return body.inertia(2, 2) > 1e-12 * body.inertia.trace();
}

LinkInertia nearest_physical(const LinkInertia& body) {
  const Mat3 about_center = body.inertia - of_center(body);
  const Mat3 second = 0.5 * about_center.trace() * Mat3::Identity() - about_center;
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(second);
  const Vec3 kept = solver.eigenvalues().cwiseMax(kThinnest * std::max(0.0, solver.eigenvalues()[2]));
  const Mat3 possible = solver.eigenvectors() * kept.asDiagonal() * solver.eigenvectors().transpose();
  LinkInertia nearest = body;
  nearest.inertia = possible.trace() * Mat3::Identity() - possible + of_center(body);
  return nearest;
}

}  // namespace armtune::internal
